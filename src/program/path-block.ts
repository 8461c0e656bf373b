import { arcByRadius, arcTangential, line } from "../kernel/arc-forms.ts";
import { cutCorner, type CornerElement } from "../kernel/corner.ts";
import { lengthOf } from "../kernel/curve.ts";
import { largestCorner, roundedDown } from "../kernel/contour.ts";
import { issue } from "../kernel/issue.ts";
import type { Move } from "../kernel/move.ts";
import type { Pt, Segment } from "../kernel/point.ts";
import { ARC_END, SAME } from "../kernel/tolerance.ts";
import { axial, diameter, toDiameter, toRadius, feed as feedNumber, type Feed as FeedNumber } from "../kernel/units.ts";
import type { AxisWord, Feed, PathKind, Words } from "../nc/statement.ts";
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
  if (held.corner) machine.say(issue("cornerElementAlone", "error", { element: 1 }, "contour"), held.corner.index);
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
    machine.held = { segment, feed, index, corner: null };
    return;
  }
  const cut = cutCorner(held.segment, segment, corner.element);
  if (!cut) {
    const { kind, size } = corner.element;
    const max = largestCorner(held.segment, segment, kind, size);
    machine.say(issue("cornerElementTooLong", "error", { element: 1, size, max, nearest: roundedDown(max) }, "contour"), corner.index);
  }
  run(machine, cut?.before ?? held.segment, held.feed, held.index);
  if (cut) run(machine, cut.between, corner.feed, corner.index);
  machine.held = { segment: cut?.after ?? segment, feed, index, corner: null };
}

/** The feed of a block: null is rapid. F stays in force, FMAX does not. */
export function blockFeed(machine: Machine, feed: Feed | undefined, index: number): FeedNumber | null {
  if (feed === "max") return (machine.lastFeed = null);
  if (feed === "auto") machine.feed = machine.toolFeed ?? machine.feed;
  else if (feed) {
    const n = machine.number(feed.value, index);
    if (n !== null) machine.feed = machine.feedOf(n);
  }
  if (machine.feed === null) machine.say(programIssue("feedMissing", "error", {}), index);
  // Without a feed the control stops; the path is shown all the same, and never as a rapid.
  if (machine.feed !== null) machine.lastFeed = machine.feed;
  return machine.feed ?? feedNumber(0);
}

/** A chamfer or rounding between plain path blocks; its own feed counts for it alone. */
export function cornerBlock(machine: Machine, element: CornerElement | null, feed: Feed | undefined, index: number): void {
  if (!element) return;
  const own = typeof feed === "object" ? machine.number(feed.value, index) : null;
  const { held } = machine;
  if (!held || held.corner) return machine.say(issue("cornerElementAlone", "error", { element: 1 }, "contour"), index);
  machine.held = { ...held, corner: { element, feed: own === null ? held.feed : machine.feedOf(own), index } };
}

function axes(machine: Machine, words: readonly AxisWord[], index: number): { x: number | null; z: number | null; moved: boolean } {
  const to = { x: machine.x, z: machine.z, moved: false };
  for (const w of words) {
    const n = machine.number(w.value, index);
    if (n === null || (w.axis !== "X" && w.axis !== "Z")) continue;
    const key = w.axis === "X" ? "x" : "z";
    const before = to[key];
    if (w.incremental && before === null) {
      machine.say(programIssue("startUnknown", "error", {}), index);
      continue;
    }
    to[key] = machine.length(n) + (w.incremental ? (before ?? 0) : 0);
    to.moved = true;
  }
  return to;
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
  if (!target.moved) {
    if (words.feed !== undefined && words.feed !== "max") blockFeed(machine, words.feed, index);
    return;
  }
  const feed = blockFeed(machine, words.feed, index);
  const named = new Set(words.axes.map((w) => w.axis));
  const polar = kind === "LP" || kind === "CP" || kind === "CTP";
  machine.sure = { x: machine.sure.x || polar || named.has("X"), z: machine.sure.z || polar || named.has("Z") };
  machine.x = target.x;
  machine.z = target.z;
  const to = machine.tip;
  if (!from || !to || !machine.tool) {
    flush(machine);
    machine.last = null;
    return;
  }
  hold(machine, segment(machine, kind, from, to, words, index), feed, index);
}

/** Where a block ends, with what it leaves out. */
export function targetOf(machine: Machine, kind: PathKind, words: Words, index: number): { x: number | null; z: number | null; moved: boolean } {
  if (kind !== "LP" && kind !== "CP" && kind !== "CTP") return axes(machine, words.axes, index);
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
