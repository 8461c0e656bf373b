import { z } from "zod/mini";
import type { ApproachForm } from "../nc/statement.ts";

/** Words of an APPR or DEP block that have a prompt of their own. SIDE is RL, RR or R0. */
export type ApproachWord = "X" | "Y" | "Z" | "PR" | "PA" | "LEN" | "CCA" | "R" | "SIDE" | "F" | "M";

/** The plane an approach runs in: X and Y of a mill, or Z and X of a turning tool. */
export type WorkingPlane = "XY" | "ZX";

/** One prompt of the dialog. */
export interface ApproachField {
  readonly word: ApproachWord;
  /** diameter: X in turning; the others as they say. */
  readonly unit: "length" | "diameter" | "angle" | "feed" | "side" | "functions";
  readonly optional: boolean;
  /** Written with "I" in front it counts from the position before. */
  readonly incremental: boolean;
  readonly range: readonly [min: number, max: number];
  readonly schema: z.ZodMiniType<number>;
}

/** What a position word of a control can hold, mm. */
const FARTHEST = 99_999.9999;
/** The finest step of a word. */
const FINEST = 0.001;

function field(word: ApproachWord, unit: ApproachField["unit"], range: readonly [number, number], more: Partial<ApproachField> = {}): ApproachField {
  const schema = z.number().check(z.gte(range[0]), z.lte(range[1]));
  return { word, unit, range, schema, optional: false, incremental: false, ...more };
}

const BOTH = [-FARTHEST, FARTHEST] as const;
const side = field("SIDE", "side", [0, 2], { optional: true });
const feed = field("F", "feed", [0, 99_999.999], { optional: true });
const functions = field("M", "functions", [0, 9999], { optional: true });
const length = field("LEN", "length", BOTH);
const centreAngle = field("CCA", "angle", [FINEST, 360]);

function position(polar: boolean, plane: WorkingPlane): readonly ApproachField[] {
  const axis = (word: ApproachWord, unit: "length" | "diameter", optional: boolean) => field(word, unit, BOTH, { optional, incremental: true });
  if (polar) {
    const angle = field("PA", "angle", BOTH, { incremental: true });
    const depth = plane === "XY" ? [axis("Z", "length", true)] : [];
    return [field("PR", "length", BOTH, { incremental: true }), angle, ...depth];
  }
  return plane === "ZX"
    ? [axis("X", "diameter", false), axis("Z", "length", false)]
    : [axis("X", "length", false), axis("Y", "length", false), axis("Z", "length", true)];
}

/** LT, LN, CT or LCT of a form, whichever way its point is written. */
export const shapeOf = (form: ApproachForm): "LT" | "LN" | "CT" | "LCT" => form.replace("P", "") as "LT" | "LN" | "CT" | "LCT";
export const isPolar = (form: ApproachForm): boolean => form.startsWith("P");

/** The prompts of APPR or DEP in the order of the control. DEP knows a position only where its end point is given (LCT). */
export function approachFields(form: ApproachForm, departing: boolean, plane: WorkingPlane): readonly ApproachField[] {
  const shape = shapeOf(form);
  const own: Record<typeof shape, readonly ApproachField[]> = {
    LT: [length],
    LN: [length],
    CT: [centreAngle, field("R", "length", BOTH)],
    LCT: [field("R", "length", [FINEST, FARTHEST])],
  };
  const depth = departing && shape !== "LCT" && plane === "XY" ? [field("Z", "length", BOTH, { optional: true, incremental: true })] : [];
  return [
    ...(departing && shape !== "LCT" ? depth : position(isPolar(form), plane)),
    ...own[shape],
    ...(departing ? [] : [side]),
    feed,
    functions,
  ];
}
