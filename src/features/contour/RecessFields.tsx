import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { UNDERCUT_FORMS } from "../../kernel/contour/undercut.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { formWord } from "../../program/blocks/recess-words.ts";
import { isDiameterWord, recessWords } from "../../program/job/read-row.ts";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { closeStep } from "../../app/document/steps.ts";
import { lazyPart } from "../../app/base/parts.ts";
import type { UndercutPlace } from "../../program/job/undercut-name.ts";

const UndercutByName = lazyPart(async () => ({ default: (await import("./UndercutByName.tsx")).UndercutByName }));

interface Props {
  readonly row: ContourRow;
  /** Counted from 1. */
  readonly number: number;
  readonly language: Language;
  readonly describedBy: string;
  /** Corner of an undercut; null while unknown. */
  readonly place: UndercutPlace | null;
  readonly isNew: boolean;
  readonly onChange: (change: Partial<ContourRow>, place: string | null) => void;
}

/** Form and words of an undercut or recess; an empty word takes its standard value, or is omitted. */
export function RecessFields({ row, number, language, describedBy, place, isNew, onChange }: Props) {
  const t = texts(language).contour;
  const forms = row.kind === "UDC" ? UNDERCUT_FORMS : (["RADIAL", "AXIAL"] as const);
  return (
    <div className="contour-recess">
      {row.kind === "UDC" && (
        <UndercutByName row={row} number={number} place={place} isNew={isNew} onChange={onChange} />
      )}
      <label>
        <span>{row.kind}</span>
        <select
          className="select"
          aria-label={t.formOf(number)}
          value={row.form}
          data-row={row.id}
          data-field="form"
          onChange={(e) => onChange({ form: e.currentTarget.value }, null)}
        >
          {forms.map((form) => (
            <option key={form} value={form}>
              {row.kind === "UDC" ? formWord(form) : form}
            </option>
          ))}
        </select>
      </label>
      {recessWords(row).map((word) => (
        <label key={word}>
          <span className="number">{isDiameterWord(row, word) ? `${word} ⌀` : word}</span>
          <NumberInput
            text={row.words[word] ?? ""}
            signed={false}
            inputMode="text"
            aria-label={t.wordOf(number, word)}
            aria-describedby={describedBy}
            data-row={row.id}
            data-field={word}
            selects
            onLeave={closeStep}
            onText={(text) => onChange({ words: { ...row.words, [word]: text } }, `${row.id} ${word}`)}
          />
        </label>
      ))}
    </div>
  );
}
