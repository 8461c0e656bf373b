import type { MeasureTexts } from "../../../i18n/en/measure.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { formatFixed } from "../../../i18n/number.ts";
import type { MeasuredKind, MeasuredMoment } from "../../../kernel/plan/measured.ts";
import { INCH } from "../../../kernel/units.ts";
import type { CurrentMeasurement } from "../../../view/measure/reading.ts";

/** A measured value as the control writes numbers: ⌀42.000, 35.000, R1.500, 30.000°. */
export function gaugedText(lengths: Lengths, kind: MeasuredKind, value: number): string {
  if (kind === "angle") return `${formatFixed(lengths.language, value, 3)}°`;
  return `${kind === "diameter" ? "⌀" : kind === "radius" ? "R" : ""}${lengths.fixed(value, 3)}`;
}

/** A length in the other unit, inches or millimetres; empty for an angle. */
export function otherText(t: MeasureTexts, { language, unit }: Lengths, kind: MeasuredKind, value: number): string {
  if (kind === "angle") return "";
  return unit === "mm" ? t.inch(formatFixed(language, value / INCH, 4)) : `${formatFixed(language, value, 3)} mm`;
}

/** The moment of the measured stock. */
export function stockMomentText(t: MeasureTexts, { block, pass }: MeasuredMoment): string {
  if (block === undefined) return t.atEnd;
  return pass === undefined ? t.moment(String(block)) : t.momentPass(String(block), String(pass));
}

/** Texts of a measurement. */
export interface MeasurementWords {
  readonly text: string;
  /** Below the text: its moment, or that it is outdated; empty if neither applies. */
  readonly caption: string;
  /** All of it in one line. */
  readonly name: string;
}

/** A measurement in words and numbers of the screen language. */
export function measurementWords(
  t: MeasureTexts,
  lengths: Lengths,
  { measurement: { kind, moment, places }, value, isStale }: CurrentMeasurement,
): MeasurementWords {
  const text = gaugedText(lengths, kind, value);
  const when = moment ? stockMomentText(t, moment) : "";
  const owners = [...new Set(places.flatMap(({ edge }) => (edge && edge.of !== "stock" ? [t.owners[edge.of]] : [])))];
  const caption = isStale ? t.old : moment?.block === undefined ? "" : when;
  return {
    text,
    caption,
    name: [`${t.kinds[kind]} ${text}`, ...owners, when, ...(isStale ? [t.old] : [])]
      .filter((each) => each !== "")
      .join(", "),
  };
}
