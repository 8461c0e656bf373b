import { partPoint, plane, type PlanePoint, type PlaneSegment } from "../kernel/plane.ts";
import { ROUND } from "../kernel/tolerance.ts";
import type { Label } from "../nc/statement.ts";
import type { Machine } from "./machine.ts";
import type { Carrier, Guide, Travel } from "./plane-chain.ts";
import type { Segment } from "../kernel/point.ts";
import type { Feed } from "../kernel/units.ts";
import { coordinatesIn, NOWHERE, type MillPlane, type Position } from "./path.ts";
import type { ApproachRun, Spot } from "./plane-types.ts";

const { apart, sweepOf } = plane;

/** A milling tool of the table: what the path needs of it, mm. */
export interface Mill {
  readonly T: number;
  readonly NAME: string;
  readonly R: number;
  readonly DR?: number;
}

/** A plane beside that of the tool axis Z. */
export type SidePlane = Exclude<MillPlane, "XY">;

/** Everything that changes while a program mills. mm. */
export class MillState implements Guide {
  /** The position as programmed. */
  at: Position = NOWHERE;
  chain: Guide["chain"] = null;
  here: PlanePoint | null = null;
  /** Radius of the tool with its delta; null when no table and no TOOL DEF names it. */
  radius: number | null = null;
  tool = "";
  /** Radii of TOOL DEF lines. */
  readonly defined = new Map<Label, number>();
  /** True while the tool axis is not Z, so that the plane is not X/Y. */
  otherAxis = false;
  /** Upper side of the blank. */
  top: number | null = null;
  /** What ran last, for an arc that leaves it tangentially in a plane beside that of the tool axis; its arc, null for a line. */
  last: { readonly from: Position; readonly to: Position; readonly plane: MillPlane; readonly segment: Segment | null } | null = null;
}

const NO_TIP: PlanePoint = { x: 0, y: 0 };

function travelLength(s: PlaneSegment, dz: number): number {
  const flat = s.kind === "line" ? apart(s.from, s.to) : sweepOf(s) * apart(s.from, s.centre);
  return Math.hypot(flat, dz);
}

/** Adds one motion of the mill. */
export function millStep(machine: Machine, s: PlaneSegment, { fromZ, toZ, feed, index }: Travel): void {
  const { mill } = machine;
  const isStill = s.kind === "line" && apart(s.from, s.to) <= ROUND;
  if ((isStill && fromZ === toZ) || !machine.roomForMove(index)) return;
  const long = travelLength(s, (toZ ?? 0) - (fromZ ?? toZ ?? 0));
  const rate = feed === null ? machine.shop.rapid : machine.now.perRevolution ? 0 : feed;
  machine.log.milled.push({
    kind: s.kind === "arc" ? "arc" : feed === null ? "rapid" : "feed",
    from: { ...s.from, z: fromZ },
    to: { ...s.to, z: toZ },
    ...(s.kind === "arc" && { centre: s.centre, turn: s.turn }),
    ...(feed !== null && { feed, feedUnit: machine.feedUnit }),
    radius: mill.radius ?? 0,
    block: machine.log.numbers[index] ?? 0,
    index,
    seconds: rate > 0 ? (60 * long) / rate : 0,
    turned: machine.log.steps.length,
  });
}

/** Adds an arc in a plane beside that of the tool axis. */
export function millSideStep(
  machine: Machine,
  plane: SidePlane,
  s: PlaneSegment,
  { before, to, feed, index }: { readonly before: Position; readonly to: Position; readonly feed: Feed | null; readonly index: number },
): void {
  const { mill } = machine;
  const [from, end] = [spotOf(before), spotOf(to)];
  if (!from || !end || !machine.roomForMove(index)) return;
  const other = plane === "ZX" ? end.y - from.y : end.x - from.x;
  const rate = feed === null ? machine.shop.rapid : machine.now.perRevolution ? 0 : feed;
  machine.log.milled.push({
    kind: s.kind === "arc" ? "arc" : feed === null ? "rapid" : "feed",
    from,
    to: end,
    ...(s.kind === "arc" && { side: { plane, centre: coordinatesIn(plane, partPoint(s.centre)), turn: s.turn } }),
    ...(feed !== null && { feed, feedUnit: machine.feedUnit }),
    radius: mill.radius ?? 0,
    block: machine.log.numbers[index] ?? 0,
    index,
    seconds: rate > 0 ? (60 * travelLength(s, other)) / rate : 0,
    turned: machine.log.steps.length,
  });
}

const spotOf = ({ x, y, z }: Position): Spot | null => (x === null || y === null ? null : { x, y, z });
/** The centre of the tool in its working plane; null while nobody knows where that is. */
export const centreOf = ({ x, y }: Position): PlanePoint | null => (x === null || y === null ? null : { x, y });

/** The tool comes from where nobody knows: a step without a way, that says where it arrives. */
export function millArrives(machine: Machine, to: PlanePoint, { toZ, feed, index }: Travel): void {
  const at = { ...to, z: toZ };
  machine.log.milled.push({
    kind: feed === null ? "rapid" : "feed",
    from: at,
    to: at,
    ...(feed !== null && { feed, feedUnit: machine.feedUnit }),
    radius: machine.mill.radius ?? 0,
    block: machine.log.numbers[index] ?? 0,
    index,
    seconds: 0,
    turned: machine.log.steps.length,
  });
}

/** The carrier of a mill: the program moves its centre. */
export function millCarrier(machine: Machine): Carrier {
  return {
    machine,
    plane: "XY",
    toolRadius: machine.mill.radius ?? 0,
    tip: NO_TIP,
    top: machine.mill.top,
    emit: (s, travel) => millStep(machine, s, travel),
    arrive: (at, travel) => millArrives(machine, at, travel),
    note: (run: ApproachRun) => machine.log.approaches.push(run),
  };
}
