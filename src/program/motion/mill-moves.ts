import { hypotenuse } from "../../kernel/geometry/vectors.ts";
import { partPoint, plane, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { rapidMinutes } from "../../kernel/time/time.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import type { Machine } from "../state/machine.ts";
import type { Travel } from "../state/plane-chain.ts";
import type { Feed } from "../../kernel/units.ts";
import { coordinatesIn, type MillPlane, type Position } from "../state/path.ts";
import type { Carrier } from "./carrier.ts";
import type { ApproachRun, PlaneStep, Spot } from "../tools/plane-types.ts";

const { apart, sweepOf } = plane;

/** A plane that contains the tool axis Z. */
export type SidePlane = Exclude<MillPlane, "XY">;

const NO_TIP: PlanePoint = { x: 0, y: 0 };

/**
 * Seconds of a motion over `long` mm. At rapid each axis has its machine rate, Y that of X; an arc is timed as a
 * straight X move of its length.
 */
function secondsOver(
  machine: Machine,
  long: number,
  { feed, line }: { readonly feed: Feed | null; readonly line: Spot | null },
): number {
  const { rapid } = machine.clock;
  if (feed === null && typeof rapid !== "number") {
    const { x, z } = rapid;
    return (
      60 *
      rapidMinutes(
        line
          ? [
              [line.x, x],
              [line.y, x],
              [line.z ?? 0, z],
            ]
          : [[long, x]],
      )
    );
  }
  const rate = feed ?? machine.shop.rapid;
  return rate > 0 && (feed === null || !machine.now.perRevolution) ? (60 * long) / rate : 0;
}

function travelLength(s: PlaneSegment, dz: number): number {
  const flat = s.kind === "line" ? apart(s.from, s.to) : sweepOf(s) * apart(s.from, s.centre);
  return hypotenuse(flat, dz);
}

/** Adds one motion of the mill. */
export function millStep(machine: Machine, s: PlaneSegment, { fromZ, toZ, feed, index }: Travel): void {
  const isStill = s.kind === "line" && apart(s.from, s.to) <= ROUND;
  if ((isStill && fromZ === toZ) || !machine.roomForMove(index)) return;
  const long = travelLength(s, (toZ ?? 0) - (fromZ ?? toZ ?? 0));
  const [from, to] = [
    { x: s.from.x, y: s.from.y, z: fromZ },
    { x: s.to.x, y: s.to.y, z: toZ },
  ];
  const [{ feedUnit }, radius, block] = [machine, machine.now.mill.radius ?? 0, machine.log.numberOf(index) ?? 0];
  const line =
    s.kind === "line" ? { x: s.to.x - s.from.x, y: s.to.y - s.from.y, z: (toZ ?? 0) - (fromZ ?? toZ ?? 0) } : null;
  const [seconds, turned] = [secondsOver(machine, long, { feed, line }), machine.log.steps.length];
  // Written out: in a long program, object copies dominate the time.
  const straight: PlaneStep =
    feed === null
      ? { kind: "rapid", from, to, radius, block, index, seconds, turned }
      : { kind: "feed", from, to, feed, feedUnit, radius, block, index, seconds, turned };
  machine.log.note(
    "milled",
    s.kind === "arc" ? { ...straight, kind: "arc", centre: s.centre, turn: s.turn } : straight,
  );
}

/** Adds an arc in a plane that contains the tool axis. */
export function millSideStep(
  machine: Machine,
  plane: SidePlane,
  s: PlaneSegment,
  {
    before,
    to,
    feed,
    index,
  }: { readonly before: Position; readonly to: Position; readonly feed: Feed | null; readonly index: number },
): void {
  const [from, end] = [spotOf(before), spotOf(to)];
  if (!from || !end || !machine.roomForMove(index)) return;
  const other = plane === "ZX" ? end.y - from.y : end.x - from.x;
  machine.log.note("milled", {
    kind: s.kind === "arc" ? "arc" : feed === null ? "rapid" : "feed",
    from,
    to: end,
    ...(s.kind === "arc" && { side: { plane, centre: coordinatesIn(plane, partPoint(s.centre)), turn: s.turn } }),
    ...(feed !== null && { feed, feedUnit: machine.feedUnit }),
    radius: machine.now.mill.radius ?? 0,
    block: machine.log.numberOf(index) ?? 0,
    index,
    seconds: secondsOver(machine, travelLength(s, other), { feed, line: null }),
    turned: machine.log.steps.length,
  });
}

const spotOf = ({ x, y, z }: Position): Spot | null => (x === null || y === null ? null : { x, y, z });
/** Tool centre in the working plane; null while unknown. */
export const centreOf = ({ x, y }: Position): PlanePoint | null => (x === null || y === null ? null : { x, y });

/** The tool comes from an unknown position: adds a step without length at its arrival. */
export function millArrives(machine: Machine, to: PlanePoint, { toZ, feed, index }: Travel): void {
  const at = { ...to, z: toZ };
  machine.log.note("milled", {
    kind: feed === null ? "rapid" : "feed",
    from: at,
    to: at,
    ...(feed !== null && { feed, feedUnit: machine.feedUnit }),
    radius: machine.now.mill.radius ?? 0,
    block: machine.log.numberOf(index) ?? 0,
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
    note: (run: ApproachRun) => machine.log.note("approaches", run),
  };
}
