import { boxAround } from "../../kernel/area/box.ts";
import { cutCorner, type CornerElement } from "../../kernel/contour/corner.ts";
import { largestCorner } from "../../kernel/contour/contour.ts";
import { issue } from "../../kernel/plan/issue.ts";
import type { Move } from "../../kernel/plan/move.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Feed as FeedNumber } from "../../kernel/units.ts";
import type { FeedWord, PolarWord, Words } from "../../nc/words.ts";
import { blockFeed, takeFeed } from "../state/block-feed.ts";
import { datumShiftOf } from "./datum.ts";
import { breaksRule } from "../state/control-rule.ts";
import { otherAxisWord, offCentre } from "./off-centre.ts";
import { frameOf } from "./transform-blocks.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import {
  coordinates,
  endOf,
  isPolarPath,
  planeOfAxes,
  pointIn,
  segmentOf,
  type PathBlock,
  type Plane,
  type Position,
  type Standing,
  type WordReader,
} from "../state/path.ts";

const purpose = { phase: "position", run: "rough", step: 0 } as const;

/** A segment as a move; a feed of null is rapid. */
export function moveOf(machine: Machine, s: Segment, feed: FeedNumber | null): Move {
  if (feed === null) return { kind: "rapid", to: s.to, ...purpose };
  const { feedUnit } = machine;
  // Written out: what is spread into an object lies outside of it, and a long path has a move for each block.
  return s.kind === "line"
    ? { kind: "feed", to: s.to, feed, feedUnit, phase: "position", run: "rough", step: 0 }
    : { kind: "arc", to: s.to, centre: s.centre, turn: s.turn, feed, feedUnit, ...purpose };
}

/** Runs the element pending for a corner; called before anything that does not belong to the contour. */
export function flushPendingElement(machine: Machine): void {
  const { pendingElement } = machine.place;
  machine.setPlace({ pendingElement: null });
  if (!pendingElement) return;
  if (pendingElement.corner)
    machine.log.report(
      issue("cornerElementAlone", "error", { element: pendingElement.element }, "contour"),
      pendingElement.corner.index,
    );
  run(machine, pendingElement.segment, pendingElement.feed, pendingElement.index);
}

function run(machine: Machine, s: Segment, feed: FeedNumber | null, index: number): void {
  if (part.lengthOf(s) > SAME) machine.step(s.from, moveOf(machine, s, feed), index);
}

/** Defers a new element until the next block shows whether a corner follows; runs the previous one. */
function deferElement(machine: Machine, segment: Segment, feed: FeedNumber | null, index: number): void {
  const { pendingElement } = machine.place;
  const { corner } = pendingElement ?? {};
  if (corner && part.lengthOf(segment) <= SAME)
    return breaksRule(machine, "zeroBehindCorner", wordOf(corner.element), index);
  if (!pendingElement || !corner) {
    flushPendingElement(machine);
    machine.setPlace({
      pendingElement: { segment, feed, index, corner: null, element: (pendingElement?.element ?? 0) + 1 },
    });
    return;
  }
  const cut = cutCorner(pendingElement.segment, segment, corner.element);
  if (!cut) {
    const { kind, size } = corner.element;
    const max = largestCorner(pendingElement.segment, segment, kind, size);
    machine.log.report(
      issue("cornerElementTooLong", "error", { element: pendingElement.element, size, max }, "contour"),
      corner.index,
    );
  }
  run(machine, cut?.before ?? pendingElement.segment, pendingElement.feed, pendingElement.index);
  if (cut) run(machine, cut.between, corner.feed, corner.index);
  machine.setPlace({
    pendingElement: { segment: cut?.after ?? segment, feed, index, corner: null, element: pendingElement.element + 1 },
  });
}

/** A chamfer or rounding between plain path blocks; its own feed counts for it alone. */
export function cornerBlock(machine: Machine, element: CornerElement, feed: FeedWord | undefined, index: number): void {
  const own = typeof feed === "object" ? machine.number(feed.value, index) : null;
  const { pendingElement } = machine.place;
  if (!pendingElement || pendingElement.corner)
    return machine.log.report(
      issue("cornerElementAlone", "error", { element: pendingElement?.element ?? 1 }, "contour"),
      index,
    );
  machine.setPlace({
    pendingElement: {
      ...pendingElement,
      corner: { element, feed: own === null ? pendingElement.feed : machine.feedOf(own), index },
    },
  });
}

const isAbsolute = (w: PolarWord | undefined) => w !== undefined && !w.incremental;

/**
 * Sets the position at the end of a block. An axis is sure after an absolute word; an incremental one keeps the
 * certainty of its start.
 */
export function standAt(machine: Machine, { path, words }: PathBlock, to: Position): void {
  const named = new Set(words.axes.filter((w) => !w.incremental).map((w) => w.axis));
  const both = isPolarPath(path) && isAbsolute(words.polarRadius) && isAbsolute(words.polarAngle);
  const { sure, lostReason } = machine.place;
  const x = to.x !== null && (sure.x || both || named.has("X"));
  const z = to.z !== null && (sure.z || both || named.has("Z"));
  machine.setPlace({ at: to, sure: { x, z }, lostReason: x && z ? null : lostReason });
}

/** Reads the words of a path block. A value unknown for a reported reason is not reported again. */
export const wordReader = (machine: Machine, index: number): WordReader => ({
  number: (value) => machine.number(value, index),
  length: (n) => machine.length(n),
  shift: (axis) => {
    const by = datumShiftOf(machine, axis);
    if (by === "unknown") machine.known.lastUnknownReason = "unproved";
    return by;
  },
  frame: frameOf(machine.now),
  otherAxis: (w, n) => otherAxisWord(machine, w, n, index),
  onUnknown: () => void machine.setPlace({ lostReason: machine.known.lastUnknownReason }),
  fault: (code) => {
    if (code === "arcImpossible" || machine.place.lostReason === null)
      machine.log.report(programIssue(code, code === "startUnknown" ? "warning" : "error", {}), index);
  },
  rule: (rule, word) => breaksRule(machine, rule, word, index),
});

/** Reference points of a block in a plane of the mill or the lathe. */
export const standing = ({ now: { pole }, place: { at, mill } }: Machine, plane: Plane): Standing => ({
  plane,
  at: plane === "lathe" ? at : mill,
  pole: pole && pointIn(plane, pole.at),
});

/** A corner element as the program spells it. */
export const wordOf = ({ kind }: CornerElement): string => (kind === "round" ? "RND" : "CHF");

/** The pole: CC with coordinates; omitted ones are the programmed position. */
export function pole(machine: Machine, { axes }: Words, index: number): void {
  const from = machine.now.turning ? machine.place.at : machine.place.mill;
  if (axes.length === 0 && machine.place.isWhole === false) breaksRule(machine, "emptyCentre", "CC", index);
  machine.set({ pole: { at: coordinates(wordReader(machine, index), axes, from), plane: planeOfAxes(axes) } });
}

/** End of a turning block; null where it moves neither axis. */
export function targetOf(machine: Machine, block: PathBlock, index: number): Position | null {
  const to = endOf(wordReader(machine, index), block, standing(machine, "lathe"));
  return isPolarPath(block.path) || block.words.axes.some((w) => w.axis === "X" || w.axis === "Z") ? to : null;
}

/** Segment of a turning block between two points. */
export function elementBetween(machine: Machine, block: PathBlock, from: Pt, to: Pt, index: number): Segment {
  const { pole } = standing(machine, "lathe");
  const last = segmentOf(wordReader(machine, index), block, { from, to, pole, before: machine.place.last });
  machine.setPlace({ last });
  return last;
}

/** A feed move with unknown start or end is not cut: it is reported unless it surely ends outside the blank. */
function cutFromNowhere(machine: Machine, to: Pt | null, index: number): void {
  const { blank } = machine.now;
  if (blank.length === 0) return;
  const { left, right, high } = boxAround(blank);
  if (to && (to.z < left || to.z > right || Math.abs(to.r) > high)) return;
  machine.log.report(programIssue("startUnknown", "warning", {}), index);
  machine.log.leaveUnproved(
    machine.blocks[index]?.raw
      .trim()
      .replace(/^\/?\d+\s*/, "")
      .slice(0, 60) ?? "",
    index,
  );
}

/** One path block: L, C, CR, CT and the polar forms. */
export function pathBlock(machine: Machine, block: PathBlock, index: number): void {
  const { words } = block;
  if (words.compensation === "RL" || words.compensation === "RR")
    machine.log.report(programIssue("radiusCompensation", "warning", { side: words.compensation }), index);
  const from = machine.place.sure.x && machine.place.sure.z ? machine.tip : null;
  const target = targetOf(machine, block, index);
  if (!target) return takeFeed(machine, words.feed, index);
  const feed = blockFeed(machine, words.feed, index);
  const { lostReason } = machine.place;
  standAt(machine, block, target);
  const to = machine.place.sure.x && machine.place.sure.z ? machine.tip : null;
  if (!from || !to || !machine.now.tool) {
    flushPendingElement(machine);
    machine.setPlace({ last: null, positionedBy: to && feed === null ? index : null });
    if (feed !== null && machine.now.tool && lostReason === null) cutFromNowhere(machine, to, index);
    return;
  }
  if (feed !== null) offCentre(machine, index);
  deferElement(machine, elementBetween(machine, block, from, to, index), feed, index);
}
