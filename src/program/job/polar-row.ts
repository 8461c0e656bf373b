import type { GivenCoordinate } from "../../kernel/solve/solve-work.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { axial, type Axial, diameter, inDegrees, type Radius, STEP, toDiameter, toRadius } from "../../kernel/units.ts";
import { noWords, type PolarWord, type Words } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import { roundedTo } from "../values/field.ts";
import type { ContourRow } from "./job.ts";
import { plainReader, polarPoint } from "../state/path.ts";
import { REQUIRED_NUMBER, reportNoMotion, rowNumber, type RowReader } from "./row-reader.ts";
import { POSITION_DECIMALS, typedValue } from "../values/typed-value.ts";

/** A word for the end of a polar element: distance from the pole in mm, angle from +Z towards +X in degrees. */
export type PolarName = "PR" | "PA";
/** Decimals a control keeps of an angle. */
const ANGLE_DECIMALS = 4;
const decimalsOf = (name: PolarName) => (name === "PR" ? POSITION_DECIMALS : ANGLE_DECIMALS);
const NAMES: Partial<Record<ContourRow["kind"], readonly PolarName[]>> = {
  LP: ["PR", "PA"],
  CP: ["PA"],
  CTP: ["PR", "PA"],
};

/** Polar words of a row; empty for other elements. */
export const polarNames = (row: ContourRow): readonly PolarName[] => NAMES[row.kind] ?? [];
export const isPolarRow = (row: ContourRow): boolean => row.kind in NAMES;

/** A polar word as typed; stored under its name, or under IPR or IPA when incremental. */
export interface PolarTyped {
  readonly text: string;
  readonly incremental: boolean;
}
export function polarTyped(row: ContourRow, name: PolarName): PolarTyped {
  const added = row.words[`I${name}`];
  return added === undefined ? { text: row.words[name] ?? "", incremental: false } : { text: added, incremental: true };
}

/** The words of a row with a polar word changed. */
export const withPolar = (words: ContourRow["words"], name: PolarName, typed: PolarTyped): ContourRow["words"] => ({
  ...Object.fromEntries(Object.entries(words).filter(([key]) => key !== name && key !== `I${name}`)),
  [typed.incremental ? `I${name}` : name]: typed.text,
});

const putWord = (name: PolarName, word: PolarWord): Partial<Words> =>
  name === "PR" ? { polarRadius: word } : { polarAngle: word };

/** The polar words of a row for its block. */
export function polarWords(row: ContourRow): Partial<Words> {
  return Object.assign(
    {},
    ...polarNames(row).map((name): Partial<Words> => {
      const { text, incremental } = polarTyped(row, name),
        value = typedValue(text, decimalsOf(name));
      return value === null ? {} : putWord(name, { value, incremental });
    }),
  ) as Partial<Words>;
}

/** A point as distance and angle about a pole. */
export const polarOf = (pole: Pt, to: Pt): Readonly<Record<PolarName, number>> => ({
  PR: roundedTo(Math.hypot(to.z - pole.z, to.r - pole.r), POSITION_DECIMALS),
  PA: roundedTo(inDegrees(Math.atan2(to.r - pole.r, to.z - pole.z)), ANGLE_DECIMALS),
});

/** Words of a row with a new end point: omitted words that are still right stay omitted. */
export function polarWordsTo(row: ContourRow, pole: Pt, before: Pt | null, to: Pt): ContourRow["words"] {
  const next = polarOf(pole, to),
    old = before && polarOf(pole, before);
  return polarNames(row).reduce((words, name) => {
    const { text, incremental } = polarTyped(row, name);
    if (text.trim() === "" && old && Math.abs(next[name] - old[name]) < STEP / 2) return words;
    return withPolar(words, name, {
      text: String(roundedTo(incremental && old ? next[name] - old[name] : next[name], decimalsOf(name))),
      incremental: incremental && old !== null,
    });
  }, row.words);
}

/** End of a polar row, as in the run of its block. */
function polarEnd(reader: RowReader, row: ContourRow, index: number): Pt | null {
  const before =
    typeof reader.x === "number" && typeof reader.z === "number"
      ? { z: axial(reader.z), r: toRadius(diameter(reader.x)) }
      : null;
  if (!reader.pole) {
    reader.issues.push({ row: index, field: null, issue: programIssue("poleMissing", "error", {}) });
    return null;
  }
  const names = polarNames(row);
  let words: Words = noWords,
    readable = true;
  for (const name of ["PR", "PA"] as const) {
    const { text, incremental } = names.includes(name) ? polarTyped(row, name) : { text: "", incremental: false };
    const empty = text.trim() === "",
      value = empty ? null : rowNumber(reader, index, name, text, REQUIRED_NUMBER);
    if (value !== null) words = { ...words, ...putWord(name, { value, incremental }) };
    else if (!empty) readable = false;
    // Without a known previous point there is nothing to inherit or to add to.
    if (before || !(empty || incremental)) continue;
    readable = false;
    const shown = names.includes(name);
    reader.issues.push({
      row: index,
      field: shown ? name : null,
      issue: shown
        ? issue("missing", "error", {}, "contour")
        : issue("contourPoint", "error", { element: index + 1 }, "contour"),
    });
  }
  if (!readable) return null;
  if (row.kind !== "CP" && !words.polarRadius && !words.polarAngle) reportNoMotion(reader, row, index);
  return polarPoint(plainReader(1), words, reader.pole, before);
}

/** End of a polar row as coordinates; where unknown, the contour stays at its position. */
export function polarGiven(
  reader: RowReader,
  row: ContourRow,
  index: number,
): { readonly z: GivenCoordinate<Axial>; readonly r: GivenCoordinate<Radius> } {
  const to = polarEnd(reader, row, index);
  if (!to)
    return {
      z: reader.z === null ? null : { by: axial(0) },
      r: reader.x === null ? null : { by: toRadius(diameter(0)) },
    };
  reader.z = to.z;
  reader.x = toDiameter(to.r);
  return { z: { at: to.z }, r: { at: to.r } };
}
