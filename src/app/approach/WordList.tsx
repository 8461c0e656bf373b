import type { ApproachDraft, ApproachReading } from "../../program/approach-draft.ts";
import type { ApproachField, ApproachWord, WorkingPlane } from "../../program/approach-fields.ts";
import { Icon } from "../Icon.tsx";
import { isOpen, type Entry } from "../findings/entry.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { shownWord, unitText, wordName, wordTexts } from "./words.ts";

/** All prompts of the block, one line each. */
export function WordList({ fields, plane, draft, reading, problems, open, goTo, inch }: {
  readonly fields: readonly ApproachField[];
  readonly plane: WorkingPlane;
  readonly draft: ApproachDraft;
  readonly reading: ApproachReading;
  readonly problems: readonly Entry[];
  readonly open: ApproachWord | null;
  readonly goTo: (word: ApproachWord) => void;
  readonly inch: boolean;
}) {
  const t = useTexts(), language = useSettings((s) => s.language);
  return (
    <ol className="prompt-list" aria-label={t.approach.list}>
      {fields.map((f) => {
        const typed = draft[f.id] ?? "";
        const shown = shownWord(t, language, f, typed, reading[f.id]);
        const unit = typed.trim() === "" ? "" : unitText(t, f, inch);
        const worst = problems.find((p) => p.at === f.id && !isOpen(p))?.issue.severity;
        const label = wordTexts(t, f.id, plane).label;
        return (
          <li key={f.id}>
            <button
              type="button" className="prompt-line" tabIndex={f.id === (open ?? fields[0]?.id) ? 0 : -1} aria-current={f.id === open ? "step" : undefined}
              aria-label={t.approach.row(wordName(f.id), label, `${shown} ${unit}`.trim()) + (worst ? `, ${t.findings.severities[worst]}` : "")}
              onClick={() => goTo(f.id)}
            >
              <span className="number line-q">{wordName(f.id)}</span>
              <span className="line-label">{label}</span>
              {worst && <span className={`line-mark ${worst}`}><Icon name={worst} /></span>}
              <span className={`number line-value${typed.trim() === "" ? " soft" : ""}`}>{shown}</span>
              <span className="line-unit soft">{unit}</span>
            </button>
          </li>
        );
      })}
    </ol>
  );
}
