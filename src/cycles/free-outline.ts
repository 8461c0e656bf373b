import { crossesChain, selfCrossing } from "../kernel/contour/crossing.ts";
import type { Frame } from "../kernel/geometry/flat.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import { tipDirection } from "../kernel/cutter/insert.ts";
import type { PlanContext } from "../kernel/plan/plan.ts";
import { at, part, type Pt, type Segment } from "../kernel/geometry/point.ts";
import { FAR } from "../kernel/strategy/tip-envelope.ts";
import { toDiameter, toRadius, type Axial, type Diameter } from "../kernel/units.ts";
import type { Dimension, Given, Outline } from "./define.ts";

/** The values of a free-contour cycle that affect its outline. */
export interface FreeValues {
  readonly Q499: number;
  readonly Q479: number;
  readonly Q480: Diameter;
  readonly Q482: Axial;
}

/** Contours from their ends, made once: values are tried many times on the same contour. */
const reversals = new WeakMap<readonly Segment[], readonly Segment[]>();

function fromItsEnd(contour: readonly Segment[]): readonly Segment[] {
  const known = reversals.get(contour) ?? contour.map(part.reversed).reverse();
  reversals.set(contour, known);
  return known;
}

/** Contour of a subprogram in machining direction: as programmed, or from its end with Q499 = 1 and 2. */
export function freeOutline(v: FreeValues, given: Given, transverse: boolean): Outline {
  const programmed = given.contour;
  const contour = v.Q499 === 0 || !programmed ? (programmed ?? []) : fromItsEnd(programmed);
  const elements = contour.map((_, i) => (v.Q499 === 0 ? i + 1 : contour.length - i));
  const open = transverse || sideOf(contour, given.start) !== "inside";
  const outline = { frame: freeFrame(contour, transverse, open), sunk: false, dimensions: [], issues: [], elements };
  const refused = (found: Issue): Outline => ({ ...outline, contour, issues: [found] });
  if (programmed === null) return refused(issue("contourMissing", "error", { label: "" }, "contour"));
  const first = contour[0]?.from;
  const last = contour.at(-1)?.to;
  if (!first || !last) return refused(issue("contourTooShort", "error", {}, "contour"));
  const flat = transverse ? first.r === last.r : first.z === last.z;
  if (flat) return refused(issue("contourFlat", "error", { axis: transverse ? "X" : "Z" }, "contour"));
  const crossing = selfCrossing(programmed);
  if (crossing)
    return refused(
      issue("contourCrossesItself", "error", { element: crossing[0] + 1, other: crossing[1] + 1 }, "contour"),
    );
  const covered = coveredEnd(contour, outline.frame);
  if (covered)
    return refused(issue("contourEndCovered", "error", { x: toDiameter(covered.r), z: covered.z }, "contour"));
  return { ...outline, contour, dimensions: v.Q479 === 1 ? limitDimensions(v, contour) : [] };
}

/**
 * The end of a contour past which the part cannot continue across the cutting direction, because an element of the
 * contour is in the way.
 */
function coveredEnd(contour: readonly Segment[], { transverse, signU }: Frame): Pt | null {
  const [first, last] = [contour[0] as Segment, contour.at(-1) as Segment];
  const beyond = (p: Pt, way: number) => (transverse ? at(p.z, p.r + way * FAR) : at(p.z + way * FAR, p.r));
  const after: Segment = { kind: "line", from: last.to, to: beyond(last.to, signU) };
  if (crossesChain(after, contour)) return last.to;
  const before: Segment = { kind: "line", from: beyond(first.from, -signU), to: first.from };
  return crossesChain(before, contour) ? first.from : null;
}

function limitDimensions(v: FreeValues, contour: readonly Segment[]): Dimension[] {
  const points = contour.flatMap((s) => [s.from, s.to]);
  const z = points.reduce((sum, p) => sum + p.z, 0) / points.length;
  const r = points.reduce((sum, p) => sum + p.r, 0) / points.length;
  return [
    { q: "Q480", form: "diameter", at: at(z, toRadius(v.Q480)) },
    { q: "Q482", form: "z", from: at(0, r), to: at(v.Q482, r) },
  ];
}

/**
 * The side of a contour on which a point lies if it is farther from the axis than the whole contour, or nearer; null
 * between.
 */
function sideOf(contour: readonly Segment[], start: Pt | null): "outside" | "inside" | null {
  const points = contour.flatMap((s) => [s.from, s.to]);
  if (start === null || points.every((p) => start.r >= p.r)) return "outside";
  return points.every((p) => start.r <= p.r) ? "inside" : null;
}

/**
 * Orientation of strategy space: u runs from the first towards the last point; the open side is +Z or away from the
 * axis, or the opposite where `open` is false.
 */
function freeFrame(contour: readonly Segment[], transverse: boolean, open: boolean): Frame {
  const [first, last] = [contour[0]?.from, contour.at(-1)?.to];
  const way = !first || !last ? 0 : transverse ? last.r - first.r : last.z - first.z;
  return { transverse, signU: way < 0 ? -1 : 1, signV: open ? 1 : -1 };
}

/**
 * The frame for cutting. The open side of a transverse contour is −Z only when a tool that points to +Z is behind the
 * contour (decision 0010). The open side of a longitudinal contour is away from the axis when the start point is
 * farther out than the contour; between its nearest and its farthest point the tip orientation decides.
 */
export function frameAt(contour: readonly Segment[], transverse: boolean, { start, tool }: PlanContext): Frame {
  const points = contour.flatMap((s) => [s.from, s.to]);
  const behind = points.every((p) => start.z <= p.z) && [3, 4, 5].includes(tool.TO);
  const side = sideOf(contour, start);
  const outside = side === null ? tipDirection(tool.TO).v <= 0 : side === "outside";
  return freeFrame(contour, transverse, transverse ? !behind : outside);
}

/**
 * The frame for a tool that plunges: between the heights of the contour, a tip that points to the axis works from
 * outside.
 */
export function plungeFrame(contour: readonly Segment[], transverse: boolean, setting: PlanContext): Frame {
  const rs = contour.flatMap((s) => [s.from.r, s.to.r]);
  const between = setting.start.r > Math.min(...rs) && setting.start.r < Math.max(...rs);
  const outwards = between && [1, 2, 3].includes(setting.tool.TO);
  return frameAt(
    contour,
    transverse,
    outwards && !transverse ? { ...setting, start: at(setting.start.z, Math.max(...rs)) } : setting,
  );
}
