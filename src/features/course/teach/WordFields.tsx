import { useId } from "react";
import type { TaskForm } from "../../../course/made/task-form.ts";
import { hasQuestions } from "../../../course/made/task-from-form.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** Props of each part of the form: its current state, and the setter. */
export interface FormPart {
  readonly made: TaskForm;
  /** `isStep`: removes typed content, so undo is offered. */
  readonly change: (some: Partial<TaskForm>, isStep?: boolean) => void;
}

/** A text of the form, of one line or of several. */
export function TeachText({
  label,
  hint,
  value,
  rows = 1,
  isNc = false,
  change,
}: {
  readonly label: string;
  readonly hint?: string;
  readonly value: string;
  readonly rows?: number;
  readonly isNc?: boolean;
  readonly change: (text: string) => void;
}) {
  const id = useId();
  const shared = {
    id,
    value,
    className: isNc ? "input number" : "input",
    spellCheck: !isNc,
    ...(hint !== undefined && { "aria-describedby": `${id}-hint` }),
  };
  return (
    <div className="teach-text">
      <label htmlFor={id}>{label}</label>
      {rows > 1 ? (
        <textarea
          {...shared}
          rows={rows}
          maxLength={isNc ? 60_000 : 2000}
          onChange={(event) => change(event.currentTarget.value)}
        />
      ) : (
        <input {...shared} maxLength={200} onChange={(event) => change(event.currentTarget.value)} />
      )}
      {hint !== undefined && (
        <p id={`${id}-hint`} className="small soft">
          {hint}
        </p>
      )}
    </div>
  );
}

/** Kind, title, assignment and the three hints. */
export function WordFields({ made, change, kinds }: FormPart & { readonly kinds: readonly TaskForm["kind"][] }) {
  const t = useTexts("course-teach");
  const name = useId();
  const { words, kind } = made;
  const say = (some: Partial<TaskForm["words"]>) => change({ words: { ...words, ...some } });
  const [one, two, three] = words.hints;
  return (
    <fieldset>
      <legend>{t.words}</legend>
      <div role="radiogroup" aria-label={t.kind} className="teach-choices">
        {kinds.map((each) => (
          <label key={each} className="teach-check">
            <input
              type="radio"
              name={name}
              checked={kind === each}
              onChange={() =>
                change({ kind: each, ...(hasQuestions(each) && made.start === "empty" && { start: "program" }) })
              }
            />
            {t.kinds[each]}
          </label>
        ))}
      </div>
      <TeachText label={t.name} value={words.title} change={(title) => say({ title })} />
      <TeachText label={t.ask} hint={t.askHint} rows={4} value={words.ask} change={(ask) => say({ ask })} />
      <TeachText label={t.hints[0] ?? ""} rows={2} value={one} change={(text) => say({ hints: [text, two, three] })} />
      <TeachText label={t.hints[1] ?? ""} rows={2} value={two} change={(text) => say({ hints: [one, text, three] })} />
      <TeachText label={t.hints[2] ?? ""} rows={2} value={three} change={(text) => say({ hints: [one, two, text] })} />
    </fieldset>
  );
}
