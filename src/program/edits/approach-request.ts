import type { ApproachRequest } from "../../kernel/plane/approach.ts";
import {
  partPoint,
  plane,
  planePoint,
  type PlanePoint,
  type PlaneSegment,
  type Side,
} from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { inDegrees, radius, rounded, toDiameter } from "../../kernel/units.ts";
import type { ApproachForm } from "../../nc/words.ts";
import { SIDES, type ApproachReading } from "./approach-draft.ts";
import { isPolar, shapeOf, type ApproachWord, type WorkingPlane } from "../motion/approach-fields.ts";
import type { KnownParameters } from "../values/expression.ts";
import type { FieldReading } from "../values/field.ts";
import { coordinatesIn, endOf, NOWHERE, plainReader, pointIn } from "../state/path.ts";

const { apart, difference, sum } = plane;

/** Surroundings of an APPR or DEP block. Lengths in mm, points in the working plane. */
export interface ApproachContext {
  readonly plane: WorkingPlane;
  /** APPR: tool position before the block (PS); null while unknown. */
  readonly before: PlanePoint | null;
  /** The programmed contour, behind APPR or before DEP, without compensation. */
  readonly contour: readonly PlaneSegment[];
  /** Active compensation: that of the contour before DEP. */
  readonly side: Side;
  readonly toolRadius: number;
  /** Vector from the tool centre to the programmed point: zero for a mill. `before` is the centre. */
  readonly tip: PlanePoint;
  /** CC, for the polar forms. */
  readonly pole: PlanePoint | null;
  /** The path to PH runs at the feed before the block: "rapid", a number, or null when none was programmed. */
  readonly feedBefore: number | "rapid" | null;
  /** Millimetres in the program's unit of length. */
  readonly unit: number;
  /** Values of Q parameters at the block. */
  readonly parameters: KnownParameters;
}

/** Block and surroundings, complete for the calculation. */
export interface ReadyApproach {
  readonly request: ApproachRequest;
  /** The programmed contour, beginning in PA or ending in PE. */
  readonly contour: readonly PlaneSegment[];
}

const SIDE_OF = { RL: "left", RR: "right", R0: "none" } as const;

const sideOf = (read: FieldReading | undefined, otherwise: Side): Side => {
  const word = read?.value === null || read?.value === undefined ? undefined : SIDES[read.value];
  return word ? SIDE_OF[word] : otherwise;
};

/** Reference of incremental words: the last contour point before DEP, the tool position for APPR. */
const origin = ({ contour, before, tip }: ApproachContext, departing: boolean) =>
  departing ? (contour.at(-1)?.to ?? null) : before && sum(before, tip);

/** Point of a block: PA, or PN of DEP LCT; null while incomplete. */
export function namedPoint(
  form: ApproachForm,
  departing: boolean,
  read: ApproachReading,
  context: ApproachContext,
): PlanePoint | null {
  const plane = context.plane === "ZX" ? "lathe" : "XY";
  const axes = context.plane === "ZX" ? (["Z", "X"] as const) : (["X", "Y"] as const);
  const word = (name: ApproachWord) => ({
    value: read[name]?.value ?? NaN,
    incremental: read[name]?.incremental ?? false,
  });
  const words = isPolar(form)
    ? { axes: [], polarRadius: word("PR"), polarAngle: word("PA") }
    : { axes: axes.map((axis) => ({ axis, ...word(axis) })) };
  const from = origin(context, departing);
  const at = from ? { ...NOWHERE, ...coordinatesIn(plane, partPoint(from)) } : NOWHERE;
  const block = {
    path: isPolar(form) ? "LP" : "L",
    words: { ...words, functions: [] },
  } as const;
  const to = endOf(plainReader(context.unit), block, { plane, at, pole: context.pole && partPoint(context.pole) });
  const point = to && pointIn(plane, to);
  return point && planePoint(point);
}

/** Moves the start of a contour: its first element becomes a line from there, unless nothing moved. */
function beginningIn(contour: readonly PlaneSegment[], at: PlanePoint): readonly PlaneSegment[] {
  const [first, ...rest] = contour;
  if (!first || apart(first.from, at) <= SAME) return contour;
  return apart(first.to, at) <= SAME
    ? rest
    : [first.kind === "line" ? { ...first, from: at } : { kind: "line", from: at, to: first.to }, ...rest];
}

/** Null while there is no contour next to the block, or its point is not complete. */
export function readyApproach(
  form: ApproachForm,
  departing: boolean,
  read: ApproachReading,
  context: ApproachContext,
): ReadyApproach | null {
  const shape = shapeOf(form);
  const named = departing && shape !== "LCT" ? null : namedPoint(form, departing, read, context);
  if (!departing && !named) return null;
  const contour = departing || !named ? context.contour : beginningIn(context.contour, named);
  const element = departing ? contour.at(-1) : contour[0];
  if (!element) return null;
  const value = (word: FieldReading | undefined, scale: number) =>
    typeof word?.value === "number" ? word.value * scale : undefined;
  const [length, size, angle] = [value(read.LEN, context.unit), value(read.R, context.unit), value(read.CCA, 1)];
  return {
    contour,
    request: {
      shape,
      departing,
      element,
      toolRadius: context.toolRadius,
      side: departing ? context.side : sideOf(read.SIDE, context.side),
      outside: departing ? (named ? difference(named, context.tip) : null) : context.before,
      ...(length !== undefined && { length }),
      ...(size !== undefined && { radius: size }),
      ...(angle !== undefined && { centreAngle: angle }),
    },
  };
}

const printed = (n: number) => String(rounded(n) + 0);

/** A point of the working plane as the words of a form. */
export function wordsOfPoint(
  form: ApproachForm,
  p: PlanePoint,
  context: ApproachContext,
): Partial<Record<ApproachWord, string>> | null {
  const { pole, unit } = context;
  if (isPolar(form)) {
    if (!pole) return null;
    const angle = inDegrees(Math.atan2(p.y - pole.y, p.x - pole.x));
    return { PR: printed(apart(p, pole) / unit), PA: printed(angle) };
  }
  return context.plane === "ZX"
    ? { X: printed(toDiameter(radius(p.y)) / unit), Z: printed(p.x / unit) }
    : { X: printed(p.x / unit), Y: printed(p.y / unit) };
}
