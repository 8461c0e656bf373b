import { useEffect, useRef } from "react";
import { isOpen } from "../../findings/entry.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { commandsOf, type Prompt, type PromptGroup, type PromptSession } from "./session.ts";

/** A group of the set-up as one row. */
const rowOf = ({ letter, name, text, unit, soft }: PromptGroup) => ({
  letter,
  label: name,
  shown: { text, unit, soft },
});

/** True if a prompt has a row; a closed group shows only its first prompt. */
function isOwnRow(field: Prompt, fields: readonly Prompt[], active: string | null): boolean {
  const { group } = field;
  if (!group || fields.some((f) => f.id === active && f.group?.id === group.id)) return true;
  return fields.find((f) => f.group?.id === group.id) === field;
}

/** All prompts, one line each. Lines never change their height, so the list never jumps. */
export function PromptList({ session, name }: { readonly session: PromptSession; readonly name: string }) {
  const t = useTexts();
  const list = useRef<HTMLOListElement>(null);
  const {
    fields,
    findings,
    opened: { id: active },
  } = session;

  const openGroup = fields.find((f) => f.id === active)?.group?.id;

  useEffect(() => {
    const box = list.current;
    const row = box?.querySelector<HTMLElement>("[aria-current]")?.parentElement;
    if (!row || !box || box.scrollHeight <= box.clientHeight) return;
    const height = row.offsetHeight;
    const top = row.offsetTop - box.offsetTop;
    if (top - height < box.scrollTop) box.scrollTop = top - height;
    else if (top + 2 * height > box.scrollTop + box.clientHeight)
      box.scrollTop = Math.ceil((top + 2 * height - box.clientHeight) / height) * height;
  }, [active]);

  return (
    <ol className="prompt-list" aria-label={name} ref={list}>
      {fields
        .filter((f) => isOwnRow(f, fields, active))
        .map((field) => {
          const { id, idle } = field;
          const { letter, label, shown } = field.group && field.group.id !== openGroup ? rowOf(field.group) : field;
          const worst = findings.find((p) => p.at === id && !isOpen(p))?.issue.severity;
          const quiet = idle ? `, ${t.dialog.idle}` : field.group && shown.soft ? `, ${t.setup.proposed}` : "";
          const note = worst ? `, ${t.findings.severities[worst]}` : "";
          return (
            <li key={id}>
              <button
                type="button"
                tabIndex={id === (active ?? fields[0]?.id) ? 0 : -1}
                className={`prompt-line${idle ? " idle" : ""}`}
                aria-current={id === active ? "step" : undefined}
                aria-label={`${t.dialog.row(letter, label, `${shown.text} ${shown.unit}`.trim())}${quiet}${note}`}
                onClick={() => commandsOf(session).goTo(id)}
              >
                <span className="number line-q">{letter}</span>
                <span className="line-label">{label}</span>
                {worst && (
                  <span className={`line-mark ${worst}`}>
                    <Icon name={worst} />
                  </span>
                )}
                <span className={`number line-value${shown.soft ? " soft" : ""}`}>{shown.text}</span>
                <span className="line-unit soft">{shown.unit}</span>
              </button>
            </li>
          );
        })}
    </ol>
  );
}
