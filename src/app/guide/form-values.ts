import { approach, type Approach, type ApproachRequest } from "../../kernel/approach.ts";
import { rounded } from "../../kernel/units.ts";

/** Words of APPR and DEP that a form is shown at three values of. */
export type SizedWord = "LEN" | "R" | "CCA";
const FIELD = { LEN: "length", R: "radius", CCA: "centreAngle" } as const;

/** A form with one of the values of a word. */
export interface FormAtValue {
  readonly value: number;
  readonly isUsual: boolean;
  readonly request: ApproachRequest;
  readonly result: Approach;
}

/** Shares of the usual value: a small and a large one. */
const LESS = 0.4;
const MORE = 2.2;
/** Most of a turn that an arc is shown with, degrees. */
const MOST_ANGLE = 270;

/** The words of a form that have a size. */
export const sizedWords = ({ shape }: Pick<ApproachRequest, "shape">): readonly SizedWord[] =>
  shape === "LCT" ? ["R"] : shape === "CT" ? ["R", "CCA"] : ["LEN"];

/** A form at a small, the usual and a large value of a word. */
export function formAtValues(request: ApproachRequest, word: SizedWord): readonly FormAtValue[] {
  const usual = request[FIELD[word]];
  if (usual === undefined) return [];
  const most = word === "CCA" ? MOST_ANGLE : Infinity;
  const values = [usual * LESS, usual, Math.min(most, usual * MORE)].map((value) => rounded(Number(value.toFixed(1))));
  return [...new Set(values)].map((value) => {
    const changed: ApproachRequest = { ...request, [FIELD[word]]: value };
    return { value, isUsual: value === usual, request: changed, result: approach(changed) };
  });
}
