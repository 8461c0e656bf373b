import type { ApproachForm } from "../../nc/words.ts";
import type { Field } from "../values/field.ts";

/** Words of APPR and DEP with a prompt. SIDE is RL, RR or R0. */
export type ApproachWord = "X" | "Y" | "Z" | "PR" | "PA" | "LEN" | "CCA" | "R" | "SIDE" | "F" | "M";

/** The plane an approach runs in: X and Y of a mill, or Z and X of a turning tool. */
export type WorkingPlane = "XY" | "ZX";

/** One prompt of the dialog; side and functions are not numeric. */
export interface ApproachField extends Omit<Field, "kind"> {
  readonly id: ApproachWord;
  readonly kind: "length" | "diameter" | "angle" | "feed" | "side" | "functions";
}

/** Largest value of a position word, mm. */
const FARTHEST = 99_999.9999;
/** The finest step of a word. */
const FINEST = 0.001;

const field = (
  id: ApproachWord,
  kind: ApproachField["kind"],
  range: Field["range"],
  more: Partial<ApproachField> = {},
): ApproachField => ({
  id,
  kind,
  range,
  optional: false,
  decimals: null,
  ...more,
});

const BOTH = [-FARTHEST, FARTHEST] as const;
const side = field("SIDE", "side", [0, 2], { optional: true });
const feed = field("F", "feed", [0, 99_999.999], { optional: true, rapid: true });
const functions = field("M", "functions", [0, 9999], { optional: true });
const length = field("LEN", "length", BOTH);
const centreAngle = field("CCA", "angle", [FINEST, 360]);

function position(polar: boolean, plane: WorkingPlane): readonly ApproachField[] {
  const axis = (word: ApproachWord, kind: "length" | "diameter", optional: boolean) =>
    field(word, kind, BOTH, { optional, increments: true });
  if (polar) {
    const angle = field("PA", "angle", BOTH, { increments: true });
    const depth = plane === "XY" ? [axis("Z", "length", true)] : [];
    return [field("PR", "length", BOTH, { increments: true }), angle, ...depth];
  }
  return plane === "ZX"
    ? [axis("X", "diameter", false), axis("Z", "length", false)]
    : [axis("X", "length", false), axis("Y", "length", false), axis("Z", "length", true)];
}

/** LT, LN, CT or LCT of a form, Cartesian or polar. */
export const shapeOf = (form: ApproachForm): "LT" | "LN" | "CT" | "LCT" =>
  form.replace("P", "") as "LT" | "LN" | "CT" | "LCT";
export const isPolar = (form: ApproachForm): boolean => form.startsWith("P");

/** Prompts of APPR or DEP in the order of the control. DEP has a position only where its end point is given (LCT). */
export function approachFields(form: ApproachForm, departing: boolean, plane: WorkingPlane): readonly ApproachField[] {
  const shape = shapeOf(form);
  const own: Record<typeof shape, readonly ApproachField[]> = {
    LT: [length],
    LN: [length],
    CT: [centreAngle, field("R", "length", BOTH)],
    LCT: [field("R", "length", [FINEST, FARTHEST])],
  };
  const depth =
    departing && shape !== "LCT" && plane === "XY"
      ? [field("Z", "length", BOTH, { optional: true, increments: true })]
      : [];
  return [
    ...(departing && shape !== "LCT" ? depth : position(isPolar(form), plane)),
    ...own[shape],
    ...(departing ? [] : [side]),
    feed,
    functions,
  ];
}
