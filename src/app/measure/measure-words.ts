import type { MeasureTexts } from "../../i18n/en/measure.ts";
import type { Lengths } from "../../i18n/lengths.ts";
import { formatFixed, formatNumber } from "../../i18n/number.ts";
import { loadMeasure } from "../../i18n/load-measure.ts";
import type { MeasuredKind, MeasuredMoment } from "../../kernel/measured.ts";
import { INCH, rounded } from "../../kernel/units.ts";
import type { MeasurementNow } from "../../view/measure/reading.ts";
import { laterTexts } from "../settings/later-texts.ts";

/** The texts of measuring, in the screen language. */
export const { useThem: useMeasureTexts } = laterTexts(loadMeasure);

/** A length with two decimals, or three where it needs them. */
const lengthText = ({ language, unit, fixed }: Lengths, value: number): string =>
  unit === "mm" ? formatFixed(language, rounded(value), Math.abs(Math.round(value * 1000) % 10) > 0 ? 3 : 2) : fixed(value, 3);

/** A measured value as it stands on a print: ⌀42.000, 35.00, R1.5, 30°. */
export function gaugedText(lengths: Lengths, kind: MeasuredKind, value: number): string {
  switch (kind) {
    case "diameter":
      return `⌀${lengths.fixed(value, 3)}`;
    case "radius":
      return `R${lengths.number(value)}`;
    case "angle":
      return `${formatNumber(lengths.language, value, 3)}°`;
    default:
      return lengthText(lengths, value);
  }
}

/** A length in the other unit, inches or millimetres; empty for an angle. */
export function otherText(t: MeasureTexts, { language, unit }: Lengths, kind: MeasuredKind, value: number): string {
  if (kind === "angle") return "";
  return unit === "mm" ? t.inch(formatFixed(language, value / INCH, 4)) : `${formatFixed(language, value, 3)} mm`;
}

/** Which moment's stock was measured. */
export function stockMomentText(t: MeasureTexts, { block, pass }: MeasuredMoment): string {
  if (block === undefined) return t.atEnd;
  return pass === undefined ? t.moment(String(block)) : t.momentPass(String(block), String(pass));
}

/** What is said of a measurement. */
export interface MeasurementWords {
  readonly text: string;
  /** Under the text: its moment, or that it is old; empty where neither is to be said. */
  readonly caption: string;
  /** All of it in one line. */
  readonly name: string;
}

/** A measurement in words and numbers of the screen language. */
export function measurementWords(
  t: MeasureTexts,
  lengths: Lengths,
  { measurement: { kind, moment, places }, value, isOld }: MeasurementNow,
): MeasurementWords {
  const text = gaugedText(lengths, kind, value);
  const when = moment ? stockMomentText(t, moment) : "";
  const owners = [...new Set(places.flatMap(({ edge }) => (edge && edge.of !== "stock" ? [t.owners[edge.of]] : [])))];
  const caption = isOld ? t.old : moment?.block === undefined ? "" : when;
  return {
    text,
    caption,
    name: [`${t.kinds[kind]} ${text}`, ...owners, when, ...(isOld ? [t.old] : [])].filter((each) => each !== "").join(", "),
  };
}
