import { extent, grown, grownRound, inFrame, type Convex } from "../reach/convex.ts";
import { lowerSideAt } from "../reach/cut-envelope.ts";
import { intervalsBelow } from "../reach/below.ts";
import {
  higherOf,
  linePiece,
  pathAlong,
  upperEnvelope,
  type Envelope,
  type Origin,
  type EnvelopePiece,
} from "../reach/envelope.ts";
import { flat, normalAt, segmentToPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { positive } from "../geometry/segments.ts";
import { insertShape, isBar } from "../cutter/insert.ts";
import { issue, type Issue, type Reason } from "../plan/issue.ts";
import type { Reach } from "../plan/plan.ts";
import { reachOver, type Bound } from "../reach/reach.ts";
import type { Tool } from "../plan/tool.ts";
import { ROUND, SAME } from "../tolerance.ts";
import { roomOf } from "../plan/track.ts";
import { aroundAxis, beyondAxis } from "./axis.ts";
import { endsBeyondSlots, centredIn, channelsOf, narrowerTool, withSlots } from "./channels.ts";

/** Extension of bounds beyond the contour, mm: longer than any part. */
export const FAR = 5000;

/** Surroundings of a contour beyond its ends. */
export interface Surroundings {
  /** Beyond the last point: the part continues at its height (null), or a wall closes the area up to `wall`. */
  readonly wall: number | null;
  /** In front of the first point: air above the level of the first point, the part at that height, or a wall. */
  readonly front: "free" | "part";
  readonly frontWall: number | null;
  /** Lower limits of the insert's lowest point: a machining limit, the floor of the area. */
  readonly floors: readonly { readonly v: number; readonly on: Origin["on"] }[];
}

/** Oversize on a contour: a rectangle ±u × ±v, plus `round` mm perpendicular to the contour everywhere. */
export interface Keep extends Flat {
  readonly round?: number;
}

/** The tip positions that do not damage the part: an envelope, and the positions at the ends of the contour. */
export interface TipEnvelope {
  readonly envelope: Envelope;
  /** Tip position when the nose touches the first and the last point of the contour. */
  readonly start: Flat;
  readonly end: Flat;
  /** Where the path along the contour begins: at `start`, or before it where another element is touched first. */
  readonly pathStart: number;
  /** The envelope without the bounds of the area: only surfaces that the tool would really touch. */
  readonly partEnvelope: Envelope;
}

/**
 * Builds the tip positions over a contour (machining direction, material on its right) for a tool, with an oversize:
 * the part is grown by its rectangle and by its all-round value.
 */
export function tipEnvelopeOver(
  contour: readonly Bound[],
  tool: Tool,
  frame: Frame,
  keep: Keep,
  s: Surroundings,
): TipEnvelope {
  const round = keep.round ?? 0;
  const shape = insertIn(tool, frame);
  const kept = (k: Convex) => grownRound(grownBy(k, keep), round);
  const insert = kept(shape);
  const turned = aroundAxis(contour, frame);
  const [first, last] = turned.ends;
  const touches = [tipAtContact(insert, first, "from"), tipAtContact(insert, last, "to")] as const;
  const edge = (from: Flat, to: Flat): Bound => ({ segment: { kind: "line", from, to }, on: "edge" });
  const chain: Bound[] = [...turned.chain];
  // The walls close the area and do not belong to the part: they have no oversize.
  const open = first.from.u - keep.u - round;
  if (turned.front) chain.unshift(...turned.front);
  else if (s.frontWall !== null)
    chain.unshift(
      edge({ u: open - FAR, v: s.frontWall }, { u: open, v: s.frontWall }),
      edge({ u: open, v: s.frontWall }, { u: open, v: first.from.v }),
      edge({ u: open, v: first.from.v }, first.from),
    );
  else if (s.front === "part") chain.unshift(edge({ u: first.from.u - FAR, v: first.from.v }, first.from));
  const close = last.to.u + keep.u + round;
  if (turned.back) chain.push(...turned.back);
  else if (s.wall !== null)
    chain.push(
      edge(last.to, { u: close, v: last.to.v }),
      edge({ u: close, v: last.to.v }, { u: close, v: s.wall }),
      edge({ u: close, v: s.wall }, { u: close + FAR, v: s.wall }),
    );
  else chain.push(edge(last.to, { u: last.to.u + FAR, v: last.to.v }));
  const slim = narrowerTool(tool);
  const [own, deeper] = [
    reachOver(chain, insert),
    slim ? reachOver(chain, kept(centredIn(insertIn(slim, frame), shape))) : [],
  ];
  const channels = channelsOf(own, deeper);
  const partEnvelope = withSlots(own, deeper, channels);
  const [start, end] = endsBeyondSlots(...touches, channels);
  const extra: EnvelopePiece[] = [];
  const bound = (u0: number, u1: number, v: number, on: Origin["on"]) => {
    const p = linePiece({ u: u0, v }, { u: u1, v }, { feature: "nose", on, corner: false });
    if (p) extra.push(p);
  };
  const low = first.from.u - FAR;
  const high = last.to.u + FAR;
  const bottom = extent(shape).minV;
  const level = first.from.v + keep.v + round - bottom;
  if (s.front === "free" && !turned.front) bound(low, start.u, level, "edge");
  for (const f of s.floors) bound(low, high, f.v - bottom, f.on);
  const axis = roomOf(
    frame,
    beyondAxis(
      tool,
      contour.map((b) => b.segment),
      frame,
    ),
  ).minV;
  if (axis > -Infinity) bound(low, high, axis, "edge");
  const envelope = extra.length === 0 ? partEnvelope : higherOf(partEnvelope, upperEnvelope(extra));
  // No element can be touched farther in front of the first point than the insert reaches ahead of its tip.
  const ahead = first.from.u - extent(insert).maxU - SAME;
  const free =
    s.front === "free" && ahead < start.u ? intervalsBelow(envelope, level, ahead, start.u)[0]?.to : undefined;
  return { envelope, start, end, pathStart: free ?? start.u, partEnvelope };
}

/** The last oversize of each insert, with the grown shape: one oversize is asked for again and again. */
const oversizes = new WeakMap<Convex, { readonly keep: Flat; readonly shape: Convex }>();

function grownBy(insert: Convex, { u, v }: Flat): Convex {
  const known = oversizes.get(insert);
  if (known?.keep.u === u && known.keep.v === v) return known.shape;
  const shape = grown(insert, u, v);
  if (shape !== insert) oversizes.set(insert, { keep: { u, v }, shape });
  return shape;
}

/** Inserts by tool, in each frame: a plan asks for its insert in every step. */
const inserts = new WeakMap<Tool, (Convex | undefined)[]>();

/** The insert in strategy space, relative to the tip. */
export function insertIn(tool: Tool, frame: Frame): Convex {
  const known = inserts.get(tool) ?? [];
  inserts.set(tool, known);
  const { transverse, signU, signV } = frame;
  return (known[(transverse ? 4 : 0) + (signU > 0 ? 2 : 0) + (signV > 0 ? 1 : 0)] ??= inFrame(
    insertShape(tool),
    frame,
  ));
}

/**
 * Reach of the insert ahead of the tip in the cutting direction, up to a height above its lowest point, mm: the part
 * that an infeed of that height brings into the material. Without a height, only the nose (or the corner of a bar).
 */
export function reachAhead(insert: Convex, height?: number): number {
  const noses = insert.filter((e) => e.kind === "arc" && e.feature === "nose");
  const nose = Math.max(0, ...noses.map((e) => (e.kind === "arc" ? e.centre.u + e.radius : 0)));
  if (height === undefined) return nose;
  const top = extent(insert).minV + height;
  return insert.reduce((most, e) => {
    if (e.kind === "arc") return most;
    const [low, high] = e.from.v <= e.to.v ? [e.from, e.to] : [e.to, e.from];
    if (low.v > top) return most;
    const k = high.v > top ? (top - low.v) / (high.v - low.v) : 1;
    return Math.max(most, low.u, low.u + k * (high.u - low.u));
  }, nose);
}

/**
 * Tip position when the nose touches an end of an element, with the normal there; where a flank keeps the nose off,
 * with the nearest possible normal. Of two corners that touch equally, the one that covers more.
 */
function tipAtContact(insert: Convex, s: FlatSegment, end: "from" | "to"): Flat {
  const n = normalAt(s, end);
  const wanted = flat.angleOf(flat.scaled(n, -1));
  let best = { off: Infinity, at: { u: 0, v: 0 } as Flat };
  for (const e of insert) {
    if (e.kind !== "arc" || e.feature !== "nose") continue;
    const inside = positive(wanted - e.start + ROUND) <= e.sweep + 2 * ROUND;
    const [a, b] = [e.start, e.start + e.sweep];
    const angle = inside ? wanted : away(wanted, a) <= away(wanted, b) ? a : b;
    const off = away(wanted, angle);
    const at = flat.onCircle(e.centre, e.radius, angle);
    // Next to a straight wall made by the oversize, the lower one, which ends the path higher up.
    const covers =
      Math.abs(at.u - best.at.u) < ROUND ? at.v < best.at.v : end === "from" ? at.u > best.at.u : at.u < best.at.u;
    if (off < best.off - ROUND || (off < best.off + ROUND && covers)) best = { off, at };
  }
  return { u: s[end].u - best.at.u, v: s[end].v - best.at.v };
}
/** Angle between two directions, radians. */
const away = (a: number, b: number) => Math.min(positive(a - b), positive(b - a));

/** The finishing path over a ground, in sections with the reason why the insert cannot go deeper. */
export function reachOf(g: TipEnvelope, u0: number, u1: number, frame: Frame, tool: Tool): Reach[] {
  return pathAlong(g.envelope, u0, u1).map((s) => ({
    path: segmentToPart(frame, s.segment),
    reason: reasonOf(s.origin, tool),
  }));
}

/** The reason why the insert cannot go deeper; if it is a side behind a cutting edge, that edge is too short. */
function reasonOf(o: Origin | null, tool: Tool): Reason | null {
  if (o === null) return null;
  if (o.on === "bridge") return "plunging";
  if (o.on === "limit") return "limit";
  if (o.on === "cutLength") return "cutLength";
  if (o.feature === "nose") return null;
  if (o.feature === "width") return o.corner ? "toolWidth" : null;
  if (isBar(tool)) return "toolWidth";
  return o.feature === "secondaryEdge" || o.feature === "behindSecondary" ? "secondaryEdge" : "mainEdge";
}

/** Whether the tool would stand inside the finished part at a place. */
export const insidePart = (part: TipEnvelope, at: Flat): boolean => at.v < lowerSideAt(part.partEnvelope, at.u) - SAME;

/** The issue for a start inside the part: every way out would damage it. `works`: a start point that works. */
export const startInPart = (works: { readonly x: number; readonly z: number }): Issue =>
  issue("startInPart", "error", works, "start");
