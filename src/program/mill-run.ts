import type { CornerElement } from "../kernel/corner.ts";
import { issue } from "../kernel/issue.ts";
import { partPoint, planePoint, planeSegment, type PlanePoint, type PlaneSegment, type Side } from "../kernel/plane.ts";
import type { AxisWord, PathKind, Statement, Words } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { millArrives, millCarrier } from "./mill-state.ts";
import { blockFeed, segment } from "./path-block.ts";
import { addCorner, beginApproach, close, endWithDeparture, followPath, isPolar, sideOf } from "./plane-guide.ts";
import { polarPoint } from "./polar.ts";

const PLANE_AXES: ReadonlySet<string> = new Set(["X", "Y", "Z"]);
/** Machine coordinates: where that is in the part, nobody knows. */
const MACHINE_COORDINATES: readonly number[] = [91, 92];

const carrierOf = (machine: Machine) => () => millCarrier(machine);

/** Carries out what waits; called before anything that does not belong to a contour. */
export const closeMill = (machine: Machine): void => close(machine.mill, carrierOf(machine));

interface Position {
  x: number | null;
  y: number | null;
  z: number | null;
}

/** The axis words of a block on top of the position before it. */
function coordinates(machine: Machine, words: readonly AxisWord[], index: number): Position {
  const { x, y, z } = machine.mill;
  const to: Position = { x, y, z };
  for (const w of words) {
    if (!PLANE_AXES.has(w.axis)) {
      machine.notSimulated(w.axis, index);
      continue;
    }
    const key = w.axis.toLowerCase() as keyof Position;
    const n = machine.number(w.value, index);
    if (n === null) continue;
    if (w.incremental && to[key] === null) machine.say(programIssue("startUnknown", "error", {}), index);
    else to[key] = machine.length(n) + (w.incremental ? (to[key] ?? 0) : 0);
  }
  return to;
}

const inPlane = (p: Position): PlanePoint | null => (p.x === null || p.y === null ? null : { x: p.x, y: p.y });

function polar(machine: Machine, words: Words, to: Position, index: number): boolean {
  const before = inPlane(machine.mill);
  const found = machine.pole && polarPoint(machine.pole, before && partPoint(before), words, (v) => machine.number(v, index), (n) => machine.length(n));
  if (!found) {
    machine.say(programIssue("poleMissing", "error", {}), index);
    return false;
  }
  ({ x: to.x, y: to.y } = planePoint(found));
  return true;
}

/** CC with coordinates, or where the tool was programmed to. */
export function millPole(machine: Machine, words: Words, index: number): void {
  const at = inPlane(coordinates(machine, words.axes, index));
  machine.pole = at && partPoint(at);
}

const POLAR: ReadonlySet<PathKind> = new Set(["LP", "CP", "CTP"]);

/** One path block: L, C, CR, CT and the polar forms. */
export function millPath(machine: Machine, kind: Exclude<PathKind, "CC" | "RND">, words: Words, index: number): void {
  const { mill } = machine;
  const requested = sideOf(words, mill.chain?.side ?? "none");
  const before: Position = { x: mill.x, y: mill.y, z: mill.z };
  const to = coordinates(machine, [...words.axes, ...words.linear], index);
  if (POLAR.has(kind) && !polar(machine, words, to, index)) return;
  const isMoving = POLAR.has(kind) || words.axes.length > 0;
  if (!isMoving && words.compensation === undefined) {
    if (words.feed !== undefined && words.feed !== "max") blockFeed(machine, words.feed, index);
    return;
  }
  if (words.functions.some((m) => MACHINE_COORDINATES.includes(m))) return elsewhere(machine, words);
  if (words.compensation !== undefined) needsRadius(machine, requested, index);
  Object.assign(mill, to);
  const [start, end] = [inPlane(before), inPlane(to)];
  if (!end) {
    if (words.feed !== undefined) blockFeed(machine, words.feed, index);
    return;
  }
  const feed = isMoving ? blockFeed(machine, words.feed, index) : machine.feed;
  const travel = { fromZ: before.z ?? to.z, toZ: to.z, feed, index };
  if (!start && requested === "none") {
    closeMill(machine);
    millArrives(machine, end, travel);
    mill.here = end;
    machine.last = null;
    return;
  }
  const pieces = start ? around(machine, kind, words, segmentOf(machine, kind, start, end, words, index), index) : [null];
  pieces.forEach((piece, i) => {
    const z = (k: number) => (travel.fromZ === null || travel.toZ === null ? travel.toZ : travel.fromZ + ((travel.toZ - travel.fromZ) * k) / pieces.length);
    followPath(mill, carrierOf(machine), requested, { ...travel, fromZ: z(i), toZ: z(i + 1), segment: piece, to: piece ? piece.to : end });
  });
}

function segmentOf(machine: Machine, kind: PathKind, start: PlanePoint, end: PlanePoint, words: Words, index: number): PlaneSegment {
  const made = segment(machine, kind, partPoint(start), partPoint(end), words, index);
  machine.last = made;
  return planeSegment(made);
}

/** CP with more than one turn: whole circles first. */
function around(machine: Machine, kind: PathKind, words: Words, s: PlaneSegment, index: number): PlaneSegment[] {
  const angle = kind === "CP" && words.polarAngle?.incremental ? machine.number(words.polarAngle.value, index) : null;
  if (s.kind !== "arc" || angle === null || Math.abs(angle) <= 360) return [s];
  const turns = Math.min(1000, Math.ceil(Math.abs(angle) / 360 - 1e-9) - 1);
  return [...Array.from({ length: turns }, (): PlaneSegment => ({ ...s, to: s.from })), s];
}

function elsewhere(machine: Machine, words: Words): void {
  const { mill } = machine;
  closeMill(machine);
  for (const { axis } of words.axes) {
    if (axis === "X") mill.x = null;
    if (axis === "Y") mill.y = null;
    if (axis === "Z") mill.z = null;
  }
  mill.here = inPlane(mill);
  machine.last = null;
}

function needsRadius(machine: Machine, side: Side, index: number): void {
  if (side !== "none" && machine.mill.radius === null) machine.say(programIssue("toolRadiusUnknown", "warning", { tool: machine.mill.tool }), index);
}

/** RND and CHF; their feed counts for them alone. */
export function millCorner(machine: Machine, element: CornerElement | null, feed: Words["feed"], index: number): void {
  if (!element) return;
  const own = typeof feed === "object" ? machine.number(feed.value, index) : null;
  const last = machine.mill.chain?.items.at(-1);
  const added = last && addCorner(machine.mill, { element, feed: own === null ? last.feed : machine.feedOf(own), index });
  if (!added) machine.say(issue("cornerElementAlone", "error", { element: 1 }, "contour"), index);
}

/** APPR and DEP. */
export function millApproach(machine: Machine, s: Extract<Statement, { kind: "approach" }>, index: number): void {
  const { mill } = machine;
  const { departing, form, words } = s;
  const fromZ = mill.z;
  const to = coordinates(machine, words.axes, index);
  if (isPolar(form) && !polar(machine, words, to, index)) return;
  needsRadius(machine, departing ? "none" : sideOf(words, "none"), index);
  const at = inPlane(to);
  const isEnd = !departing || form === "LCT" || form === "PLCT";
  const target = isEnd ? at : null;
  if (isEnd && !target) return machine.say(programIssue("startUnknown", "error", {}), index);
  const block = { departing, form, words, index, target, fromZ: fromZ ?? to.z, toZ: to.z };
  if (departing) endWithDeparture(mill, carrierOf(machine), block);
  else beginApproach(mill, carrierOf(machine), block);
  mill.z = to.z;
  const end = departing ? mill.here : target;
  [mill.x, mill.y] = [end?.x ?? mill.x, end?.y ?? mill.y];
  machine.last = null;
}
