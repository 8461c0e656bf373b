import { flat, toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { noseReach } from "../cutter/insert.ts";
import type { Bound } from "../reach/reach.ts";
import { ROUND, SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";

/*
 * The workpiece rotates about the axis: beyond it is the mirror image of this side, and a cylinder without a radius
 * does not exist. The bounds of a tool there are decided here for every strategy (decision "The axis").
 */

/** Greater than the thickness of any part, mm. */
const DEEP = 5000;

/** A contour as a bound of the tool, and the bounds beyond an end on the axis (null: the end is elsewhere). */
export interface TurnedChain {
  readonly chain: readonly Bound[];
  /** The elements that the ends of a path along the contour touch. */
  readonly ends: readonly [FlatSegment, FlatSegment];
  readonly front: readonly Bound[] | null;
  readonly back: readonly Bound[] | null;
}

const radiusOf = (frame: Frame, p: Flat): number => toPart(frame, p).r;

/** True for a cylinder about the axis with no radius, or a negative one. */
function isBare({ segment: { kind, from, to } }: Bound, frame: Frame): boolean {
  const [a, b] = [radiusOf(frame, from), radiusOf(frame, to)];
  return kind === "line" && a <= SAME && Math.abs(a - b) <= SAME;
}

/** A contour in machining direction with the bounds at the axis. */
export function aroundAxis(contour: readonly Bound[], frame: Frame): TurnedChain {
  if (frame.transverse) return acrossAxis(contour, frame);
  const [first, last] = [(contour[0] as Bound).segment, (contour.at(-1) as Bound).segment];
  // Inside machining does not cut on the far side of the axis.
  if (frame.signV < 0) return { chain: contour, ends: [first, last], front: null, back: null };
  const nothing = (p: Flat) => (radiusOf(frame, p) <= SAME ? [] : null);
  const chain = contour.flatMap((b, i) => (isBare(b, frame) ? trench(b, i > 0, i < contour.length - 1) : [b]));
  return { chain, ends: [first, last], front: nothing(first.from), back: nothing(last.to) };
}

/** Where a contour runs along the axis there is no material: a trench between its neighbours. */
function trench({ segment: { from, to }, on }: Bound, before: boolean, behind: boolean): Bound[] {
  const low = (p: Flat): Flat => ({ u: p.u, v: p.v - DEEP });
  const line = (a: Flat, b: Flat): Bound => ({ segment: { kind: "line", from: a, to: b }, on });
  return [...(before ? [line(from, low(from))] : []), line(low(from), low(to)), ...(behind ? [line(low(to), to)] : [])];
}

/** Across the axis: the contour up to it, and its mirror image. */
function acrossAxis(contour: readonly Bound[], frame: Frame): TurnedChain {
  const solid = [...contour];
  while (solid.length > 1 && isBare(solid.at(-1) as Bound, frame)) solid.pop();
  while (solid.length > 1 && isBare(solid[0] as Bound, frame)) solid.shift();
  const ends = [(solid[0] as Bound).segment, (solid.at(-1) as Bound).segment] as const;
  const meets = (p: Flat) => radiusOf(frame, p) <= SAME;
  // Towards the axis the contour ends on it, away from the axis it begins on it.
  if (frame.signU < 0 && meets(ends[1].to)) {
    const [chain, back] = joinedAtAxis(upToAxis(solid, frame));
    const rear = (back.at(-1) ?? (chain.at(-1) as Bound)).segment.to;
    return { chain, ends, front: null, back: [...back, level(rear, Math.max(rear.u, ends[1].to.u) + DEEP)] };
  }
  if (frame.signU > 0 && meets(ends[0].from)) {
    // The other direction is the same, seen from the far side.
    const [back, chain] = joinedAtAxis(
      upToAxis(solid.map(reversed).reverse(), frame).map((b) => mirrored(reversed(b))),
    );
    const face = (back[0] as Bound).segment.from;
    const beyond = level(face, Math.min(face.u, ends[0].from.u) - DEEP);
    return { chain, ends, front: [reversed(beyond), ...back], back: null };
  }
  return { chain: solid, ends, front: null, back: null };
}

/** A chain up to the axis and its mirror image behind it; a face common to both is one element. */
function joinedAtAxis(chain: readonly Bound[]): readonly [Bound[], Bound[]] {
  const image = chain.map(mirrored).reverse();
  const [last, next] = [chain.at(-1) as Bound, image[0] as Bound];
  const isFace = last.segment.kind === "line" && Math.abs(last.segment.from.v - last.segment.to.v) <= ROUND;
  if (!isFace) return [[...chain], image];
  return [[...chain.slice(0, -1), { ...last, segment: { ...last.segment, to: next.segment.to } }], image.slice(1)];
}

/** A level line from a place: beyond the end of a contour, however far across the axis it is stated. */
const level = (p: Flat, u: number): Bound => ({
  segment: { kind: "line", from: p, to: { u, v: p.v } },
  on: "edge",
});

const reversed = (b: Bound): Bound => ({ ...b, segment: flat.reversed(b.segment) });

/** The mirror image of an element beyond the axis, reversed: its turn stays the same. */
function mirrored({ segment: s, on }: Bound): Bound {
  const image = ({ u, v }: Flat): Flat => ({ u: -u, v });
  const ends = { from: image(s.to), to: image(s.from) };
  return { segment: s.kind === "line" ? { kind: "line", ...ends } : { ...s, ...ends, centre: image(s.centre) }, on };
}

/** The part of a chain on this side of the axis. */
function upToAxis(chain: readonly Bound[], frame: Frame): Bound[] {
  const out = [...chain];
  while (out.length > 1 && radiusOf(frame, (out.at(-1) as Bound).segment.from) <= SAME) out.pop();
  const last = out.at(-1) as Bound;
  if (radiusOf(frame, last.segment.to) < -ROUND)
    out[out.length - 1] = { ...last, segment: cutAtAxis(last.segment, frame) };
  return out;
}

/** An element that crosses the axis, cut off at the axis. */
function cutAtAxis(s: FlatSegment, frame: Frame): FlatSegment {
  const on = flat.pointsOn(s);
  let [near, beyond] = [0, 1];
  // Bisection finds the axis on lines and arcs alike.
  while (beyond - near > ROUND) {
    const middle = (near + beyond) / 2;
    if (radiusOf(frame, on(middle)) > 0) near = middle;
    else beyond = middle;
  }
  return { ...s, to: { u: 0, v: on(beyond).v } };
}

/** For longitudinal outside machining no level is deeper than the axis; a height in strategy space. */
export const axisFloor = ({ transverse, signV }: Frame): number => (!transverse && signV > 0 ? 0 : -Infinity);

/**
 * Greatest travel of the tip past the axis, mm: the cut ends when the centre of the nose is on the axis; a contour
 * drawn beyond the axis is followed.
 */
export function beyondAxis(tool: Tool, contour: readonly FlatSegment[], frame: Frame): number {
  let least = Infinity;
  for (const { from, to } of contour) least = Math.min(least, radiusOf(frame, from), radiusOf(frame, to));
  return least < SAME ? Math.max(0, -least) + noseReach(tool) : 0;
}
