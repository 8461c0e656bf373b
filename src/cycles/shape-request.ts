import type { Segment } from "../kernel/geometry/point.ts";
import type { NamedThread } from "../kernel/thread/named-thread.ts";
import { rounded, toRadius, type Axial, type Diameter, type Length } from "../kernel/units.ts";
import type { Cycle, TurnedShape } from "./define.ts";
import { valuesOfThread } from "./thread-values.ts";

/** Where a shape is turned: on the circumference, in a bore, on a face. */
export type Site = "outside" | "inside" | "face";

/** A corner of the box round a shape, as programmed. */
export interface Corner {
  readonly diameter: Diameter;
  readonly z: Axial;
}

/** The shape that the user wants to turn, in shop terms; the app finds the cycle. */
export interface ShapeRequest {
  readonly site: Site;
  readonly shape: TurnedShape;
  /** The corner where the shape begins, on the open side, and the opposite corner: its depth and its end. */
  readonly from: Corner;
  readonly to: Corner;
  /** Angle of a taper or of flanks, degrees, as the cycles count it; 0: square. */
  readonly angle: number;
  /** Pitch of a thread, mm. */
  readonly pitch: number;
  /** The thread that was asked for by its name; absent or null: a metric profile of diameter and pitch. */
  readonly thread?: NamedThread | null;
  /** The section of a free contour, in either direction. */
  readonly contour: readonly Segment[] | null;
  /** Chamfer of 45° at the front edge of a step, mm; absent or 0: none. */
  readonly chamfer?: Length | 0;
  /** Stock allowance square to the shape, mm; 0: turned from solid. */
  readonly allowance: Length | 0;
}

/**
 * An angle of a cycle. A face stays square; a taper is an angle of the surface, in a plunge and a groove an angle of
 * the flanks.
 */
function angleFor(text: string, q: string, { shape, angle }: ShapeRequest): number {
  if (text === "faceAngle") return 0;
  if (text === "surfaceAngle") return shape === "step" ? angle : 0;
  return shape === "groove" || (shape === "plunge" && q === "Q495") ? angle : 0;
}

/** The distance of the farthest corner of a solid box from the shape in it. */
const depthOfBox = (from: Corner, to: Corner) =>
  rounded(Math.min(Math.abs(toRadius(from.diameter) - toRadius(to.diameter)), Math.abs(from.z - to.z)));

/** The chamfer of a step on the circumference or in a bore; other shapes have none. */
export const chamferOf = ({ site, shape, chamfer = 0 }: ShapeRequest): number =>
  shape === "step" && site !== "face" ? chamfer : 0;

/** Geometry values by their Q, with the same meaning in each cycle. */
const GEOMETRY: Readonly<Record<string, (wanted: ShapeRequest, text: string, example: number) => number>> = {
  Q491: ({ from }) => from.diameter,
  Q492: ({ from }) => from.z,
  Q493: ({ to }) => to.diameter,
  Q494: ({ to }) => to.z,
  Q495: (wanted, text) => angleFor(text, "Q495", wanted),
  Q496: (wanted, text) => angleFor(text, "Q496", wanted),
  Q500: () => 0,
  Q501: (wanted) => (chamferOf(wanted) > 0 ? 1 : 0),
  Q502: (wanted, _, example) => chamferOf(wanted) || example,
  Q503: () => 0,
  Q461: ({ site }) => (site === "face" ? 1 : 0),
  Q464: () => 0,
  Q471: ({ site }) => (site === "inside" ? 1 : 0),
  Q472: ({ pitch }) => pitch,
  Q473: () => 0,
  Q475: () => 1,
  Q476: () => 0,
  Q485: ({ allowance, from, to }) => allowance || depthOfBox(from, to),
};

/** The values of a cycle for a requested shape, by Q; all other values as in its printed example. */
export function valuesFor({ params, thread: roles }: Cycle, wanted: ShapeRequest): Readonly<Record<string, number>> {
  const values = Object.fromEntries(
    Object.entries(params).map(([q, { text, example }]) => [q, GEOMETRY[q]?.(wanted, text, example) ?? example]),
  );
  const named = roles && wanted.thread && valuesOfThread(wanted.thread, roles, values, { aim: "middle", nose: null });
  return named && typeof named !== "string" ? { ...values, ...named.values } : values;
}

/** Whether a cycle can cut the thread that was asked for by its name. */
export const canCutThread = ({ thread: roles }: Cycle, { thread }: ShapeRequest): boolean =>
  !roles || !thread || typeof valuesOfThread(thread, roles, {}, { aim: "middle", nose: null }) !== "string";

/** Whether a cycle can make the requested chamfer. */
export const canMakeChamfer = ({ contour, params }: Cycle, wanted: ShapeRequest): boolean =>
  chamferOf(wanted) === 0 || contour === "free" || params["Q501"] !== undefined;

/** Whether a cycle can make the requested angle. */
export const canMakeAngle = (cycle: Cycle, wanted: ShapeRequest): boolean => {
  if (wanted.angle === 0 || cycle.contour === "free") return true;
  const values = valuesFor(cycle, wanted);
  return values["Q495"] === wanted.angle || values["Q496"] === wanted.angle;
};

/** A cycle without a start diameter of its own begins its contour at the tip at the call. */
export const beginsAtTip = ({ contour, params }: Cycle): boolean => contour === "own" && params["Q491"] === undefined;
