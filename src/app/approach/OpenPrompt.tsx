import { useId, type RefObject } from "react";
import type { ApproachField, WorkingPlane } from "../../program/approach-fields.ts";
import type { FieldReading } from "../../program/field.ts";
import { formatNumber } from "../../i18n/number.ts";
import { FieldMessage } from "../dialog/FieldMessage.tsx";
import type { ValueField } from "../dialog/ValueInput.tsx";
import type { Entry } from "../findings/entry.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { SideInput } from "./SideInput.tsx";
import type { Prompts } from "./use-prompts.ts";
import { unitText, wordName, wordTexts } from "./words.ts";
import { WordInput } from "./WordInput.tsx";

/** The open prompt, large: question, value, unit, range, what is wrong, what it means. */
export function OpenPrompt({ open, place, plane, inch, text, reading, problems, prompts, ownKeypad, field, onText }: {
  readonly open: ApproachField;
  /** "3 of 7" */
  readonly place: string;
  readonly plane: WorkingPlane;
  readonly inch: boolean;
  readonly text: string;
  readonly reading: FieldReading | undefined;
  /** What concerns this word, and the block as a whole. */
  readonly problems: readonly Entry[];
  readonly prompts: Prompts;
  readonly ownKeypad: boolean;
  readonly field: RefObject<ValueField | null>;
  readonly onText: (text: string) => void;
}) {
  const t = useTexts(), id = useId(), language = useSettings((s) => s.language);
  const words = wordTexts(t, open.id, plane);
  const name = t.approach.value(wordName(open.id), words.prompt);
  const [min, max] = open.range;
  const ranged = open.kind !== "side" && open.kind !== "functions";
  const waits = reading && reading.value === null && typeof reading.written === "object" && reading.written !== null;
  return (
    <section className="active-prompt" aria-label={t.dialog.active} onKeyDown={prompts.onKeyDown}>
      <header>
        <span className="number prompt-q">{wordName(open.id)}</span>
        <h2>{words.prompt}</h2>
        <span className="soft small prompt-position">{place}</span>
      </header>
      {open.kind === "side"
        ? <SideInput text={text} name={name} describedBy={`${id}-about`} focus={prompts.focus} onText={onText} />
        : (
          <div className="value-row">
            <WordInput
              text={text} name={name} describedBy={`${id}-range ${id}-about`} ownKeypad={ownKeypad} focus={prompts.focus} field={field} onText={onText}
              invalid={text.trim() !== "" && problems.some((p) => p.at === open.id && p.issue.severity === "error")}
            />
            <span className="unit number">{unitText(t, open, inch)}</span>
          </div>
        )}
      <p className="range small soft" id={`${id}-range`}>
        {ranged && <span>{t.dialog.rangeLabel} <span className="number">{t.dialog.range(formatNumber(language, min, 4), formatNumber(language, max, 4))}</span></span>}
        {open.optional && <span>{t.dialog.optional}</span>}
        {open.increments && <span>{t.approach.incremental}</span>}
      </p>
      <div className="about" id={`${id}-about`} tabIndex={0} role="group" aria-label={t.dialog.aboutPrompt(wordName(open.id))}>
        <div role="status" aria-label={t.findings.title}>
          {problems.map((problem, i) => (
            <FieldMessage
              key={i} problem={problem} decimals={3} calm={problem.issue.code === "missing"} {...(problem.at !== null && problem.at !== open.id ? { place: problem.at } : {})}
              {...(problem.at === open.id ? { onTake: (n: number) => onText(String(n)) } : {})}
            />
          ))}
          {waits && <p className="field-message info">{t.approach.parameter}</p>}
        </div>
        <p className="explanation">{words.about}</p>
      </div>
    </section>
  );
}
