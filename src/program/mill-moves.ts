import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { partPoint, plane, type PlanePoint, type PlaneSegment } from "../kernel/plane.ts";
import { ROUND } from "../kernel/tolerance.ts";
import type { Machine } from "./machine.ts";
import type { Travel } from "./plane-chain.ts";
import type { Feed } from "../kernel/units.ts";
import { coordinatesIn, type MillPlane, type Position } from "./path.ts";
import type { Carrier } from "./carrier.ts";
import type { ApproachRun, PlaneStep, Spot } from "./plane-types.ts";

const { apart, sweepOf } = plane;

/** A plane beside that of the tool axis Z. */
export type SidePlane = Exclude<MillPlane, "XY">;

const NO_TIP: PlanePoint = { x: 0, y: 0 };

function travelLength(s: PlaneSegment, dz: number): number {
  const flat = s.kind === "line" ? apart(s.from, s.to) : sweepOf(s) * apart(s.from, s.centre);
  return hypotenuse(flat, dz);
}

/** Adds one motion of the mill. */
export function millStep(machine: Machine, s: PlaneSegment, { fromZ, toZ, feed, index }: Travel): void {
  const isStill = s.kind === "line" && apart(s.from, s.to) <= ROUND;
  if ((isStill && fromZ === toZ) || !machine.roomForMove(index)) return;
  const long = travelLength(s, (toZ ?? 0) - (fromZ ?? toZ ?? 0));
  const rate = feed === null ? machine.shop.rapid : machine.now.perRevolution ? 0 : feed;
  const [from, to] = [{ x: s.from.x, y: s.from.y, z: fromZ }, { x: s.to.x, y: s.to.y, z: toZ }];
  const [{ feedUnit }, radius, block] = [machine, machine.now.mill.radius ?? 0, machine.log.numbers[index] ?? 0];
  const [seconds, turned] = [rate > 0 ? (60 * long) / rate : 0, machine.log.steps.length];
  // Written out: of the many objects of a long program, copies of objects take most of the time.
  const straight: PlaneStep = feed === null
    ? { kind: "rapid", from, to, radius, block, index, seconds, turned }
    : { kind: "feed", from, to, feed, feedUnit, radius, block, index, seconds, turned };
  machine.log.milled.push(s.kind === "arc" ? { ...straight, kind: "arc", centre: s.centre, turn: s.turn } : straight);
}

/** Adds an arc in a plane beside that of the tool axis. */
export function millSideStep(
  machine: Machine,
  plane: SidePlane,
  s: PlaneSegment,
  { before, to, feed, index }: { readonly before: Position; readonly to: Position; readonly feed: Feed | null; readonly index: number },
): void {
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
    radius: machine.now.mill.radius ?? 0,
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
    radius: machine.now.mill.radius ?? 0,
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
    toolRadius: machine.now.mill.radius ?? 0,
    tip: NO_TIP,
    top: machine.now.mill.top,
    emit: (s, travel) => millStep(machine, s, travel),
    arrive: (at, travel) => millArrives(machine, at, travel),
    note: (run: ApproachRun) => machine.log.approaches.push(run),
  };
}
