import { ANGLE_WORDS, UNDERCUT_FORMS, type RecessWord, type RecessWords } from "../../kernel/contour/undercut.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { recessWords } from "../../program/job/read-row.ts";
import { nameOfUndercut, type NamedUndercut, type UndercutPlace } from "../../program/job/undercut-name.ts";
import { anyNumber, readText } from "../../program/values/field.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { UndercutNames } from "../../app/fields/undercut/UndercutNames.tsx";

interface Props {
  readonly row: ContourRow;
  /** Counted from 1. */
  readonly number: number;
  /** Null while the corner is unknown. */
  readonly place: UndercutPlace | null;
  /** Put in just now: the designation is the first thing to type. */
  readonly isNew: boolean;
  readonly onChange: (change: Partial<ContourRow>, place: string | null) => void;
}

/** The designation of an undercut in the contour: a name fills its words, and words of the standard have a name. */
export function UndercutByName({ row, number, place, isNew, onChange }: Props) {
  const words = useTextsOrNull("undercuts");
  const { per } = useLengths();
  const present = nameOf(row, per, place);
  return (
    words && (
      <UndercutNames
        words={words}
        label={words.of(number)}
        place={place}
        present={present}
        hint={present?.udc?.form === "F" ? words.notes.faceOfF : null}
        isNew={isNew}
        field={{ "data-row": row.id, "data-field": "undercut" }}
        onTake={({ udc }) => udc && onChange({ form: udc.form, words: typedWords(udc.words, per) }, null)}
      />
    )
  );
}

const isAngle = (word: string) => ANGLE_WORDS.has(word as RecessWord);

/** Words in mm as typed in the unit of the program. */
const typedWords = (words: RecessWords, per: number): ContourRow["words"] =>
  Object.fromEntries(
    Object.entries(words).map(([word, n]) => [
      word,
      String(isAngle(word) || per === 1 ? n : Number((n / per).toFixed(4))),
    ]),
  );

/** The designation of a row's words, read in the unit of the program. */
function nameOf(row: ContourRow, per: number, place: UndercutPlace | null): NamedUndercut | null {
  const form = UNDERCUT_FORMS.find((f) => f === row.form);
  if (!form) return null;
  const words = Object.fromEntries(
    recessWords(row).flatMap((word) => {
      const { value } = readText(anyNumber, row.words[word] ?? "");
      return value === null ? [] : [[word, isAngle(word) ? value : value * per] as const];
    }),
  );
  return nameOfUndercut(form, words, place);
}
