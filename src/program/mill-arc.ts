import { partPoint, planeSegment } from "../kernel/plane.ts";
import { arcByRadius, arcTangential, line } from "../kernel/arc-forms.ts";
import { ARC_END, SAME } from "../kernel/tolerance.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import type { Feed } from "../kernel/units.ts";
import type { AxisName, PathKind, Words } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { inPlane, type MillPole, type Plane, type Position, type SidePlane } from "./mill-position.ts";
import { millSideStep } from "./mill-state.ts";

/** A block that moves on an arc in a plane beside that of the tool axis. */
export interface SideBlock {
  readonly kind: PathKind;
  readonly words: Words;
  readonly before: Position;
  readonly to: Position;
  readonly feed: Feed | null;
  readonly index: number;
}

/** The plane of the axes that a block names: that of the tool axis unless it names Z with one of the others. */
export function planeOfAxes(named: readonly AxisName[]): Plane {
  const has = (axis: AxisName) => named.includes(axis);
  if (!has("Z") || (has("X") && has("Y"))) return "XY";
  return has("X") ? "ZX" : has("Y") ? "YZ" : "XY";
}

const NAMED_BY_POLE: ReadonlySet<PathKind> = new Set(["C", "CP"]);
const NAMED_BY_END: ReadonlySet<PathKind> = new Set(["CR", "CT"]);

/** The plane that an arc runs in: its pole's, or that of its end point. CP with an axis of its own is a helix round the tool axis. */
export function planeOf(machine: Machine, kind: PathKind, words: Words): Plane {
  const named = words.axes.map((w) => w.axis);
  if (NAMED_BY_END.has(kind)) return planeOfAxes(named);
  if (!NAMED_BY_POLE.has(kind) || (kind === "CP" && named.length > 0)) return "XY";
  return machine.mill.pole?.plane ?? "XY";
}

/** A pole in the plane in which a block needs it; null when a coordinate is not known. */
export function poleInPlane(pole: MillPole, plane: Plane): Pt | null {
  const at = inPlane(pole.at, plane);
  return at && partPoint(at);
}

/** What ran last, in the plane of an arc that leaves it tangentially. */
function segmentBefore(machine: Machine, plane: SidePlane): Segment | null {
  const { last } = machine.mill;
  if (!last) return null;
  if (last.plane === plane && last.segment) return last.segment;
  const [from, to] = [inPlane(last.from, plane), inPlane(last.to, plane)];
  return last.segment || !from || !to || Math.hypot(to.x - from.x, to.y - from.y) <= SAME ? null : line(partPoint(from), partPoint(to));
}

function arcOf(machine: Machine, plane: SidePlane, from: Pt, to: Pt, { kind, words, index }: SideBlock): Segment | null {
  const turn = words.turn ?? "ccw";
  if (kind === "CR") {
    const r = words.radius === undefined ? null : machine.number(words.radius, index);
    return r === null ? null : arcByRadius(from, to, machine.length(r), turn).segment;
  }
  if (kind === "CT") {
    const before = segmentBefore(machine, plane);
    return before && arcTangential(before, to);
  }
  const centre = machine.mill.pole && poleInPlane(machine.mill.pole, plane);
  if (!centre) return null;
  const [a, b] = [from, to].map((p) => Math.hypot(p.z - centre.z, p.r - centre.r)) as [number, number];
  return Math.abs(a - b) <= ARC_END && a > SAME ? { kind: "arc", from, to, centre, turn } : null;
}

/** Runs an arc in a plane beside that of the tool axis, as programmed, without compensation. */
export function millSideArc(machine: Machine, plane: SidePlane, block: SideBlock): void {
  const { before, to, index } = block;
  const [start, end] = [inPlane(before, plane), inPlane(to, plane)];
  if (!start || !end) return;
  const made = arcOf(machine, plane, partPoint(start), partPoint(end), block);
  if (!made) machine.say(programIssue("arcImpossible", "error", {}), index);
  const path = planeSegment(made ?? line(partPoint(start), partPoint(end)));
  machine.mill.last = { from: before, to, plane, segment: made?.kind === "arc" ? made : null };
  machine.last = null;
  millSideStep(machine, plane, path, block);
}
