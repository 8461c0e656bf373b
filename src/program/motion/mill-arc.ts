import { planeSegment } from "../../kernel/plane/plane.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Feed } from "../../kernel/units.ts";
import type { PathKind } from "../../nc/words.ts";
import type { Machine } from "../state/machine.ts";
import { millSideStep, type SidePlane } from "./mill-moves.ts";
import { standing, wordReader } from "./path-block.ts";
import { planeOfAxes, pointIn, segmentOf, type MillPlane, type PathBlock, type Position } from "../state/path.ts";

/** An arc block in a plane that contains the tool axis. */
export interface SideBlock {
  readonly block: PathBlock;
  readonly before: Position;
  readonly to: Position;
  readonly feed: Feed | null;
  readonly index: number;
}

const NAMED_BY_POLE: ReadonlySet<PathKind> = new Set(["C", "CP"]);
const NAMED_BY_END: ReadonlySet<PathKind> = new Set(["CR", "CT"]);

/** Plane of an arc: that of its pole, or of its end point. CP with its own axis is a helix about the tool axis. */
export function planeOf(machine: Machine, { path, words }: PathBlock): MillPlane {
  if (NAMED_BY_END.has(path)) return planeOfAxes(words.axes);
  if (!NAMED_BY_POLE.has(path) || (path === "CP" && words.axes.length > 0)) return "XY";
  return machine.now.pole?.plane ?? "XY";
}

/** Previous segment, in the plane of a tangential arc. */
function segmentBefore(machine: Machine, plane: SidePlane): Segment | null {
  const { milled: last } = machine.place;
  if (!last) return null;
  if (last.plane === plane && last.segment) return last.segment;
  const [from, to] = [pointIn(plane, last.from), pointIn(plane, last.to)];
  return last.segment || !from || !to || Math.hypot(to.z - from.z, to.r - from.r) <= SAME ? null : part.line(from, to);
}

/** Runs an arc in a plane that contains the tool axis, as programmed, without compensation. */
export function millSideArc(machine: Machine, plane: SidePlane, side: SideBlock): void {
  const { block, before, to, index } = side;
  const [start, end] = [pointIn(plane, before), pointIn(plane, to)];
  if (!start || !end) return;
  const course = { from: start, to: end, pole: standing(machine, plane).pole, before: segmentBefore(machine, plane) };
  const made = segmentOf(wordReader(machine, index), block, course);
  machine.setPlace({ milled: { from: before, to, plane, segment: made.kind === "arc" ? made : null } });
  machine.setPlace({ last: null });
  millSideStep(machine, plane, planeSegment(made), side);
}
