import { arcByRadius, arcTangential, line } from "../kernel/arc-forms.ts";
import { cutCorner, type CornerElement } from "../kernel/corner.ts";
import { lengthOf } from "../kernel/curve.ts";
import { largestCorner, roundedDown } from "../kernel/contour.ts";
import { issue } from "../kernel/issue.ts";
import type { Move } from "../kernel/move.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import { ARC_END, SAME } from "../kernel/tolerance.ts";
import { axial, diameter, toDiameter, toRadius, type Feed as FeedNumber } from "../kernel/units.ts";
import type { AxisWord, Feed, PathKind, PolarWord, Words } from "../nc/statement.ts";
import { blockFeed, takeFeed } from "./block-feed.ts";
import { shiftOf } from "./datum.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { polarPoint } from "./polar.ts";

const purpose = { phase: "position", run: "rough", step: 0 } as const;

/** A segment as a move; a feed of null is rapid. */
export function moveOf(machine: Machine, s: Segment, feed: FeedNumber | null): Move {
  if (feed === null) return { kind: "rapid", to: s.to, ...purpose };
  const feeding = { feed, feedUnit: machine.feedUnit, ...purpose };
  return s.kind === "line" ? { kind: "feed", to: s.to, ...feeding } : { kind: "arc", to: s.to, centre: s.centre, turn: s.turn, ...feeding };
}

/** Runs the element that waited for a corner; called before anything that does not belong to the contour. */
export function flush(machine: Machine): void {
  const { held } = machine;
  machine.held = null;
  if (!held) return;
  if (held.corner) machine.say(issue("cornerElementAlone", "error", { element: held.element }, "contour"), held.corner.index);
  run(machine, held.segment, held.feed, held.index);
}

function run(machine: Machine, s: Segment, feed: FeedNumber | null, index: number): void {
  if (lengthOf(s) > SAME) machine.step(s.from, moveOf(machine, s, feed), index, null);
}

/** Holds a new element back until the next block shows whether a corner follows; runs the one before. */
function hold(machine: Machine, segment: Segment, feed: FeedNumber | null, index: number): void {
  const { held } = machine;
  const { corner } = held ?? {};
  machine.last = segment;
  if (!held || !corner) {
    flush(machine);
    machine.held = { segment, feed, index, corner: null, element: (held?.element ?? 0) + 1 };
    return;
  }
  const cut = cutCorner(held.segment, segment, corner.element);
  if (!cut) {
    const { kind, size } = corner.element;
    const max = largestCorner(held.segment, segment, kind, size);
    machine.say(issue("cornerElementTooLong", "error", { element: held.element, size, max, nearest: roundedDown(max) }, "contour"), corner.index);
  }
  run(machine, cut?.before ?? held.segment, held.feed, held.index);
  if (cut) run(machine, cut.between, corner.feed, corner.index);
  machine.held = { segment: cut?.after ?? segment, feed, index, corner: null, element: held.element + 1 };
}

/** A chamfer or rounding between plain path blocks; its own feed counts for it alone. */
export function cornerBlock(machine: Machine, element: CornerElement | null, feed: Feed | undefined, index: number): void {
  if (!element) return;
  const own = typeof feed === "object" ? machine.number(feed.value, index) : null;
  const { held } = machine;
  if (!held || held.corner) return machine.say(issue("cornerElementAlone", "error", { element: held?.element ?? 1 }, "contour"), index);
  machine.held = { ...held, corner: { element, feed: own === null ? held.feed : machine.feedOf(own), index } };
}

/** An axis beside X and Z: where it turns or moves, nobody here knows. */
function otherAxis(machine: Machine, w: AxisWord, index: number): void {
  const n = machine.number(w.value, index);
  if (n !== null && n !== 0) machine.leaveUnproved(`${w.incremental ? "I" : ""}${w.axis}`, index);
}

/** The words of X and Z on top of the position before the block; null where nobody knows. */
function axes(machine: Machine, words: readonly AxisWord[], index: number): { x: number | null; z: number | null; moved: boolean } {
  const to = { x: machine.x, z: machine.z, moved: false };
  for (const w of words) {
    if (w.axis !== "X" && w.axis !== "Z") {
      otherAxis(machine, w, index);
      continue;
    }
    const n = machine.number(w.value, index);
    const key = w.axis === "X" ? "x" : "z";
    const before = to[key];
    to.moved = true;
    if (n === null) to[key] = machine.lose();
    else if (!w.incremental) to[key] = machine.length(n) + shiftOf(machine, w.axis);
    else if (before !== null) to[key] = before + machine.length(n);
    else if (machine.lost === null) machine.say(programIssue("startUnknown", "warning", {}), index);
  }
  return to;
}

const isPolar = (kind: PathKind) => kind === "LP" || kind === "CP" || kind === "CTP";
const isAbsolute = (w: PolarWord | undefined) => w !== undefined && !w.incremental;

/** Takes over the end of a block. An axis is sure from an absolute word on: an incremental one is as sure as what it starts from. */
export function standAt(machine: Machine, kind: PathKind | null, words: Words, to: { readonly x: number | null; readonly z: number | null }): void {
  const named = new Set(words.axes.filter((w) => !w.incremental).map((w) => w.axis));
  const both = kind !== null && isPolar(kind) && isAbsolute(words.polarRadius) && isAbsolute(words.polarAngle);
  machine.sure = { x: to.x !== null && (machine.sure.x || both || named.has("X")), z: to.z !== null && (machine.sure.z || both || named.has("Z")) };
  machine.x = to.x;
  machine.z = to.z;
  if (machine.sure.x && machine.sure.z) machine.lost = null;
}

const point = (x: number, z: number): Pt => ({ z: axial(z), r: toRadius(diameter(x)) });

/** The pole: CC with coordinates, or where the tip stands. */
export function pole(machine: Machine, words: Words, index: number): void {
  const at = axes(machine, words.axes, index);
  machine.pole = at.x === null || at.z === null ? null : point(at.x, at.z);
}

/** One path block: L, C, CR, CT and the polar forms. */
export function pathBlock(machine: Machine, kind: Exclude<PathKind, "CC" | "RND">, words: Words, index: number): void {
  if (words.compensation === "RL" || words.compensation === "RR")
    machine.say(programIssue("radiusCompensation", "warning", { side: words.compensation }), index);
  const from = machine.sure.x && machine.sure.z ? machine.tip : null;
  const target = targetOf(machine, kind, words, index);
  if (!target.moved) return takeFeed(machine, words.feed, index);
  const feed = blockFeed(machine, words.feed, index);
  standAt(machine, kind, words, target);
  const to = machine.sure.x && machine.sure.z ? machine.tip : null;
  if (!from || !to || !machine.tool) {
    flush(machine);
    machine.last = null;
    return;
  }
  hold(machine, segment(machine, kind, from, to, words, index), feed, index);
}

/** Where a block ends, with what it leaves out. */
export function targetOf(machine: Machine, kind: PathKind, words: Words, index: number): { x: number | null; z: number | null; moved: boolean } {
  if (!isPolar(kind)) return axes(machine, words.axes, index);
  const to = machine.pole && polarPoint(machine.pole, machine.tip, words, (v) => machine.number(v, index), (n) => machine.length(n));
  if (!to) machine.say(programIssue("poleMissing", "error", {}), index);
  return to ? { x: toDiameter(to.r), z: to.z, moved: true } : { x: machine.x, z: machine.z, moved: false };
}

/** The element of a block between two points. */
export function segment(machine: Machine, kind: PathKind, from: Pt, to: Pt, words: Words, index: number): Segment {
  const turn = words.turn ?? "ccw";
  const impossible = (): Segment => {
    machine.say(programIssue("arcImpossible", "error", {}), index);
    return line(from, to);
  };
  switch (kind) {
    case "CR": {
      const r = words.radius === undefined ? null : machine.number(words.radius, index);
      return (r !== null && arcByRadius(from, to, machine.length(r), turn).segment) || impossible();
    }
    case "C": case "CP": {
      if (!machine.pole) {
        machine.say(programIssue("poleMissing", "error", {}), index);
        return line(from, to);
      }
      const centre = machine.pole;
      const [a, b] = [from, to].map((p) => Math.hypot(p.z - centre.z, p.r - centre.r)) as [number, number];
      return Math.abs(a - b) <= ARC_END && a > SAME ? { kind: "arc", from, to, centre, turn } : impossible();
    }
    case "CT": case "CTP": return (machine.last && arcTangential(machine.last, to)) || impossible();
    default: return line(from, to);
  }
}
