import type { CornerElement } from "../kernel/corner.ts";
import { issue } from "../kernel/issue.ts";
import { partPoint, planePoint, planeSegment, type PlanePoint, type PlaneSegment, type Side } from "../kernel/plane.ts";
import type { PathKind, Statement, Words } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { blockFeed, takeFeed } from "./block-feed.ts";
import { millSideArc, planeOf, planeOfAxes, poleInPlane, type SideBlock } from "./mill-arc.ts";
import { coordinates, inPlane, offPlane, type Position, type SidePlane } from "./mill-position.ts";
import { millArrives, millCarrier } from "./mill-state.ts";
import { segment } from "./path-block.ts";
import { startUnknown } from "./turn-run.ts";
import { addCorner, beginApproach, close, endWithDeparture, followPath, isPolar, sideOf } from "./plane-guide.ts";
import { polarPoint } from "./polar.ts";

const carrierOf = (machine: Machine) => () => millCarrier(machine);

/** Carries out what waits; called before anything that does not belong to a contour. */
export const closeMill = (machine: Machine): void => close(machine.mill, carrierOf(machine));

function polar(machine: Machine, kind: PathKind, words: Words, to: Position, index: number): boolean {
  const { mill } = machine;
  const plane = kind === "LP" ? (mill.pole?.plane ?? "XY") : planeOf(machine, kind, words);
  const [pole, before] = [mill.pole && inPlane(mill.pole.at, plane), inPlane(mill, plane)];
  const found = pole && polarPoint(partPoint(pole), before && partPoint(before), words, (v) => machine.number(v, index), (n) => machine.length(n));
  if (found) Object.assign(to, offPlane(planePoint(found), plane));
  else if (!pole && machine.lost === null) machine.say(programIssue("poleMissing", "error", {}), index);
  else Object.assign(to, { x: null, y: null });
  return found !== null;
}

/** CC with coordinates; those it leaves out are where the tool was programmed to. */
export function millPole(machine: Machine, words: Words, index: number): void {
  machine.mill.pole = { at: coordinates(machine, words.axes, index), plane: planeOfAxes(words.axes.map((w) => w.axis)) };
  machine.pole = poleInPlane(machine.mill.pole, "XY");
}

const POLAR: ReadonlySet<PathKind> = new Set(["LP", "CP", "CTP"]);

/** One path block: L, C, CR, CT and the polar forms. */
export function millPath(machine: Machine, kind: Exclude<PathKind, "CC" | "RND">, words: Words, index: number): void {
  const { mill } = machine;
  const requested = sideOf(words, mill.chain?.side ?? "none");
  const before: Position = { x: mill.x, y: mill.y, z: mill.z };
  const to = coordinates(machine, [...words.axes, ...words.linear], index);
  if (POLAR.has(kind) && !polar(machine, kind, words, to, index)) return;
  const isMoving = POLAR.has(kind) || words.axes.length > 0;
  if (!isMoving && words.compensation === undefined) return takeFeed(machine, words.feed, index);
  if (words.compensation !== undefined) needsRadius(machine, requested, index);
  Object.assign(mill, to);
  const [start, end] = [inPlane(before), inPlane(to)];
  if (to.x !== null && to.y !== null && to.z !== null) machine.lost = null;
  if (!end) {
    closeMill(machine);
    mill.here = null;
    return takeFeed(machine, words.feed, index);
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
  const plane = planeOf(machine, kind, words);
  if (plane !== "XY" && start) return sideArc(machine, plane, { kind, words, before, to, feed, index, requested });
  mill.last = { from: before, to, plane: "XY", segment: null };
  const pieces = start ? around(machine, kind, words, segmentOf(machine, kind, start, end, words, index), index) : [null];
  pieces.forEach((piece, i) => {
    const z = (k: number) => (travel.fromZ === null || travel.toZ === null ? travel.toZ : travel.fromZ + ((travel.toZ - travel.fromZ) * k) / pieces.length);
    followPath(mill, carrierOf(machine), requested, { ...travel, fromZ: z(i), toZ: z(i + 1), segment: piece, to: piece ? piece.to : end });
  });
}

/** An arc beside the plane of the tool axis. The path before it is finished first: compensation does not reach it. */
function sideArc(machine: Machine, plane: SidePlane, block: SideBlock & { readonly requested: Side }): void {
  const { mill } = machine;
  const { requested, index, to } = block;
  closeMill(machine);
  if (requested !== "none") machine.leaveUnproved(block.kind, index);
  millSideArc(machine, plane, block);
  mill.here = inPlane(to);
}

function segmentOf(machine: Machine, kind: PathKind, start: PlanePoint, end: PlanePoint, words: Words, index: number): PlaneSegment {
  machine.pole = machine.mill.pole && poleInPlane(machine.mill.pole, "XY");
  const { mill } = machine;
  const made = segment(machine, kind, partPoint(start), partPoint(end), words, index);
  machine.last = made;
  if (mill.last && made.kind === "arc") mill.last = { ...mill.last, segment: made };
  return planeSegment(made);
}

/** CP with more than one turn: whole circles first. */
function around(machine: Machine, kind: PathKind, words: Words, s: PlaneSegment, index: number): PlaneSegment[] {
  const angle = kind === "CP" && words.polarAngle?.incremental ? machine.number(words.polarAngle.value, index) : null;
  if (s.kind !== "arc" || angle === null || Math.abs(angle) <= 360) return [s];
  const turns = Math.min(1000, Math.ceil(Math.abs(angle) / 360 - 1e-9) - 1);
  return [...Array.from({ length: turns }, (): PlaneSegment => ({ ...s, to: s.from })), s];
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
  if (!added) machine.say(issue("cornerElementAlone", "error", { element: Math.max(1, machine.mill.chain?.items.length ?? 0) }, "contour"), index);
}

/** APPR and DEP. */
export function millApproach(machine: Machine, s: Extract<Statement, { kind: "approach" }>, index: number): void {
  const { mill } = machine;
  const { departing, form, words } = s;
  const fromZ = mill.z;
  const to = coordinates(machine, words.axes, index);
  if (isPolar(form) && !polar(machine, "CTP", words, to, index)) return;
  needsRadius(machine, departing ? "none" : sideOf(words, "none"), index);
  const at = inPlane(to);
  const isEnd = !departing || form === "LCT" || form === "PLCT";
  const target = isEnd ? at : null;
  if (isEnd && !target) return startUnknown(machine, index);
  const block = { departing, form, words, index, target, fromZ: fromZ ?? to.z, toZ: to.z };
  if (departing) endWithDeparture(mill, carrierOf(machine), block);
  else beginApproach(mill, carrierOf(machine), block);
  mill.z = to.z;
  const end = departing ? mill.here : target;
  [mill.x, mill.y] = [end?.x ?? mill.x, end?.y ?? mill.y];
  machine.last = null;
}
