import { useEffect, useRef } from "react";
import type { ParamTextId } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { usePlace } from "../place.ts";
import { isOpen } from "../findings/entry.ts";
import { usePromptFindings } from "../findings/use-findings.ts";
import type { JobReading } from "../reading.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { goTo, unitOf } from "./prompts.ts";
import { writeValue } from "./write-value.ts";

/** All prompts, one line each. Lines never change their height, so the list never jumps. */
export function PromptList({ read }: { readonly read: JobReading }) {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const active = usePlace((p) => p.prompt);
  const problems = usePromptFindings();
  const list = useRef<HTMLOListElement>(null);
  const first = Object.keys(read.cycle.params)[0];

  useEffect(() => {
    const box = list.current;
    const row = box?.querySelector<HTMLElement>("[aria-current]")?.parentElement;
    if (!row || !box || box.scrollHeight <= box.clientHeight) return;
    const height = row.offsetHeight;
    const top = row.offsetTop - box.offsetTop;
    if (top - height < box.scrollTop) box.scrollTop = top - height;
    else if (top + 2 * height > box.scrollTop + box.clientHeight) box.scrollTop = Math.ceil((top + 2 * height - box.clientHeight) / height) * height;
  }, [active]);

  return (
    <ol className="prompt-list" aria-label={t.dialog.list} ref={list}>
      {Object.entries(read.cycle.params).map(([q, param]) => {
        const words = t.params[param.text as ParamTextId];
        const field = read.reading.perField[q];
        const written = field ? writeValue(language, param, field) : null;
        const shown = field?.empty ? (param.optional ? t.dialog.noEntry : t.dialog.noValue) : (written ?? read.draft[q] ?? "");
        const unit = written === null || field?.empty || field?.written === "auto" ? "" : t.dialog.units[unitOf(param, read.job.perRevolution)];
        const worst = problems.find((p) => p.at === q && !isOpen(p))?.issue.severity;
        const note = worst ? `, ${t.findings.severities[worst]}` : "";
        return (
          <li key={q}>
            <button
              type="button"
              tabIndex={q === (active ?? first) ? 0 : -1}
              className="prompt-line"
              aria-current={q === active ? "step" : undefined}
              aria-label={`${t.dialog.row(q, words.label, `${shown} ${unit}`.trim())}${note}`}
              onClick={() => goTo(q)}
            >
              <span className="number line-q">{q}</span>
              <span className="line-label">{words.label}</span>
              {worst && <span className={`line-mark ${worst}`}><Icon name={worst} /></span>}
              <span className={`number line-value${field?.empty ? " soft" : ""}`}>{shown}</span>
              <span className="line-unit soft">{unit}</span>
            </button>
          </li>
        );
      })}
    </ol>
  );
}
