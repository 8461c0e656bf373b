import type { ArcOf } from "../geometry/segments.ts";
import type { Move } from "../plan/move.ts";
import { part, type Pt, type Segment } from "../geometry/point.ts";
import type { Spindle } from "./step.ts";
import { turnsIn } from "./thread-turns.ts";
import { NOTHING } from "../tolerance.ts";

/** The path of the theoretical tip in one move. */
export function pathOf(from: Pt, move: Move): Segment {
  return move.kind === "arc"
    ? { kind: "arc", from, to: move.to, centre: move.centre, turn: move.turn }
    : { kind: "line", from, to: move.to };
}

/** Length of the tip's path in one move, mm. */
export function travelOf(path: Segment): number {
  if (path.kind === "line") return part.lengthOf(path);
  const p = part.polarOf(path);
  return (Math.abs(p.sweep) * (p.startRadius + p.endRadius)) / 2;
}

/** Minutes per revolution for each mm of radius at a cutting speed in m/min. */
const surface = (cuttingSpeed: number) => (2 * Math.PI) / (1000 * cuttingSpeed);

/** Minutes per revolution at a distance of `r` mm from the axis. */
function minutesPerTurn(spindle: Spindle, r: number): number {
  if (spindle.kind === "constant") return 1 / spindle.speed;
  return Math.max(spindle.limit > 0 ? 1 / spindle.limit : 0, surface(spindle.cuttingSpeed) * Math.abs(r));
}

/** Spindle speed in rpm at a distance of `r` mm from the axis. */
export const speedAt = (spindle: Spindle, r: number): number => 1 / minutesPerTurn(spindle, r);

/** Whether a spindle at constant surface speed reaches its speed limit at a distance of `r` mm from the axis. */
export const isAtLimit = (spindle: Spindle, r: number): boolean =>
  spindle.kind === "surface" && spindle.limit > 0 && surface(spindle.cuttingSpeed) * Math.abs(r) * spindle.limit < 1;

/** Cutting speed in m/min at a distance of `r` mm from the axis, at a spindle speed in rpm. */
export const cuttingSpeedAt = (rpm: number, r: number): number => (2 * Math.PI * Math.abs(r) * rpm) / 1000;

/**
 * Distances from the axis where the spindle speed starts or stops following the diameter; in between, minutes per
 * revolution are linear.
 */
function bends(spindle: Spindle): number[] {
  if (spindle.kind === "constant") return [];
  const knee = spindle.limit > 0 ? 1 / (spindle.limit * surface(spindle.cuttingSpeed)) : 0;
  return [-knee, knee];
}

/** Mean minutes per revolution along a straight line between two distances from the axis: exact, piece by piece. */
function meanAlongLine(spindle: Spindle, from: number, to: number): number {
  if (Math.abs(to - from) < NOTHING) return minutesPerTurn(spindle, from);
  const bent = bends(spindle)
    .map((r) => (r - from) / (to - from))
    .filter((t) => t > 0 && t < 1);
  // Most moves have none; this fast path matters for long paths, recomputed with every change.
  if (bent.length === 0) return (minutesPerTurn(spindle, from) + minutesPerTurn(spindle, to)) / 2;
  const stops = [0, ...bent, 1].sort((a, b) => a - b);
  let sum = 0;
  for (let i = 1; i < stops.length; i += 1) {
    const [a, b] = [stops[i - 1] ?? 0, stops[i] ?? 1];
    const [start, end] = [a, b].map((t) => minutesPerTurn(spindle, from + (to - from) * t)) as [number, number];
    sum += ((b - a) * (start + end)) / 2;
  }
  return sum;
}

/**
 * Number of intervals for the numerical mean along a whole arc, and along one of half a radian at most (Simpson's rule;
 * even).
 */
const PIECES = 32,
  FEW_PIECES = 8,
  SHORT_TURN = 0.5;

function meanAlongArc(spindle: Spindle, path: ArcOf<Pt>): number {
  if (spindle.kind === "constant") return minutesPerTurn(spindle, path.from.r);
  const { start, sweep, startRadius, endRadius } = part.polarOf(path),
    pieces = Math.abs(sweep) <= SHORT_TURN ? FEW_PIECES : PIECES;
  let sum = 0;
  for (let i = 0; i <= pieces; i += 1) {
    const weight = i === 0 || i === pieces ? 1 : i % 2 === 1 ? 4 : 2,
      on = i / pieces;
    const out = path.centre.r + (startRadius + (endRadius - startRadius) * on) * Math.sin(start + sweep * on);
    sum += weight * minutesPerTurn(spindle, out);
  }
  return sum / (3 * pieces);
}

/**
 * Rapid traverse of an axis: rate in mm/min, and acceleration and deceleration in m/s². Without an acceleration it
 * reaches its rate at once.
 */
export interface AxisRapid {
  readonly rate: number;
  readonly acceleration?: number;
}

/** Rapid traverse of a tool: one rate along its path, mm/min, or one per axis. */
export type RapidRate = number | { readonly x: AxisRapid; readonly z: AxisRapid };

/** Travel of an axis, mm, and its rapid traverse. */
type AxisWay = readonly [way: number, axis: AxisRapid];

/**
 * Minutes of a straight rapid from stop to stop: the axes start and arrive together, so the axis that takes longest for
 * its share sets rate and acceleration of all.
 */
export function rapidMinutes(ways: readonly AxisWay[]): number {
  const moving = ways.filter(([way]) => Math.abs(way) > 0);
  const travel = Math.sqrt(moving.reduce((sum, [way]) => sum + way * way, 0));
  const along = (of: (axis: AxisRapid) => number) =>
    Math.min(...moving.map(([way, axis]) => (of(axis) * travel) / Math.abs(way)));
  if (moving.length === 0) return 0;
  const rate = along((axis) => axis.rate);
  // In mm/min²: 1 m/s² is 1000 mm/s².
  const acceleration = along(({ acceleration: a }) => (a === undefined ? Infinity : a * 1000 * 60 * 60));
  const ramps = (rate * rate) / acceleration;
  return ramps <= travel ? travel / rate + rate / acceleration : 2 * Math.sqrt(travel / acceleration);
}

/**
 * The rapid rate of the axis with the largest share of a straight motion, mm/min: the greatest possible feed along it.
 */
export function axisRate(rapid: RapidRate, from: Pt, to: Pt): number {
  if (typeof rapid === "number") return rapid;
  return Math.abs(to.z - from.z) >= Math.abs(to.r - from.r) ? rapid.z.rate : rapid.x.rate;
}

/** The spindle limited to the machine's greatest speed, rpm; the same object if it never exceeds it. */
export function withinLimit(spindle: Spindle, most: number): Spindle {
  if (spindle.kind === "constant") return spindle.speed <= most ? spindle : { ...spindle, speed: most };
  return spindle.limit > 0 && spindle.limit <= most ? spindle : { ...spindle, limit: most };
}

/** Kind of time of a move: cutting is everything at a feed, threads included. */
export const causeOf = (move: Move): "cutting" | "rapid" | "dwell" =>
  move.kind === "rapid" ? "rapid" : move.kind === "feed" && move.dwell !== undefined ? "dwell" : "cutting";

const meanOf = (spindle: Spindle, path: Segment) =>
  path.kind === "line" ? meanAlongLine(spindle, path.from.r, path.to.r) : meanAlongArc(spindle, path);

/**
 * Seconds that a move takes. A feed per revolution follows the spindle exactly, also at constant cutting speed; a
 * thread runs at the speed of its start. A move without feed or speed takes no time.
 */
export function secondsOf(from: Pt, move: Move, spindle: Spindle, rapid: RapidRate): number {
  const path = pathOf(from, move);
  const seconds = 60 * minutesOf(path, move, spindle, rapid);
  return Number.isFinite(seconds) && seconds > 0 ? seconds : 0;
}

function minutesOf(path: Segment, move: Move, spindle: Spindle, rapid: RapidRate): number {
  const travel = travelOf(path);
  switch (move.kind) {
    case "rapid":
      return typeof rapid === "number"
        ? travel / rapid
        : rapidMinutes([
            [path.to.z - path.from.z, rapid.z],
            [path.to.r - path.from.r, rapid.x],
          ]);
    case "feed":
      if (move.dwell !== undefined) return move.dwell * minutesPerTurn(spindle, move.to.r);
      return move.feedUnit === "mm/min" ? travel / move.feed : (travel / move.feed) * meanOf(spindle, path);
    case "arc":
      return move.feedUnit === "mm/min" ? travel / move.feed : (travel / move.feed) * meanOf(spindle, path);
    case "thread":
      return turnsIn(path.from, move) * minutesPerTurn(spindle, path.from.r);
  }
}
