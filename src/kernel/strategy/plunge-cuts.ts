import { pathAlong, type Interval } from "../reach/envelope.ts";
import { flat, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import type { Basin } from "./basins.ts";
import type { TipEnvelope } from "./tip-envelope.ts";
import { partsOf } from "./infeed.ts";
import type { Cutter } from "./link.ts";
import { reachOfStep, type Places, type Spacing } from "./plunge-places.ts";
import { liftUnder } from "./valley.ts";

/** Input of a plunge. Lengths mm, feeds in the unit of the track. */
export interface PlungeCut {
  /** Distance kept from the stock, before a plunge and between two of them. */
  readonly clearance: number;
  readonly feed: number;
  /** Feed in solid material, with no free side. */
  readonly solidFeed: number;
  /** Greatest depth of one bite; between two bites the tool retracts to break the chip. 0: in one go. */
  readonly bite: number;
  /** Dwell at the bottom of each plunge, in spindle revolutions. */
  readonly dwell: number;
  /** Retract at an angle, away from the stock next to the tool, if an earlier plunge has made room; else straight. */
  readonly aslant: boolean;
}

export interface PlungeRough extends PlungeCut {
  readonly ground: TipEnvelope;
  readonly basins: readonly Basin[];
  readonly places: readonly Places[];
  readonly spacing: Spacing;
  /** Height at which cutting begins. */
  readonly top: number;
  /** Range of the tip between machining limits. */
  readonly room: Interval;
}

/** Retraction between two bites, mm. */
export const CHIP_BREAK = 0.5;
/** Greatest sideways travel when retracting from a plunge at an angle, mm. */
const ASLANT = 2;
/** Residual material between plunges on a wall or a floor is cut if it is thicker than this, mm. */
const LEFT = 0.02;

const p = (step: number, pass?: number): Purpose => ({
  phase: "rough",
  run: "rough",
  step,
  ...(pass !== undefined && { pass }),
});

/** Number of bites of a plunge. */
export const bitesOf = (depth: number, bite: number): number => (bite > 0 ? partsOf(depth, bite) : 1);

/** Number of bites taken, and the deepest of them, mm. */
export interface Bites {
  readonly passes: number;
  readonly infeed: number;
}

/**
 * The steps 1 to 5 of recessing: section by section, first all plunges, then the residual material along the walls. A
 * plunge without stock above its place is left out, as next to a blank lower than the start point.
 */
export function roughByPlunges(cutter: Cutter, r: PlungeRough): Bites {
  const done: Flat[] = [];
  let [passes, infeed] = [0, 0];
  r.basins.forEach((basin, i) => {
    const { full, webs } = r.places[i] as Places;
    for (const place of [...full, ...webs]) {
      if (cutter.frontier.freeFrom(place.u) > place.v + SAME) {
        const count = bitesOf(r.top - place.v, r.bite);
        plunge(cutter, r, place, done, { pass: passes, step: passes === 0 ? 1 : 4, count });
        passes += count;
        infeed = Math.max(infeed, (r.top - place.v) / count);
        clearBeside(cutter, r.spacing, place, done);
        retract(cutter, r, place, done);
      } else clearBeside(cutter, r.spacing, place, done);
      done.push(place);
    }
    alongWalls(cutter, r, basin);
  });
  return { passes, infeed };
}

interface Numbering {
  readonly pass: number;
  readonly step: number;
  readonly count: number;
}

/** Plunges to a place in bites; at the feed for solid material below the free depth on either side. */
function plunge(
  cutter: Cutter,
  r: PlungeRough,
  place: Flat,
  done: readonly Flat[],
  { pass, step, count }: Numbering,
): void {
  const beside = done.filter((d) => Math.abs(d.u - place.u) < r.spacing.width - SAME);
  const free = beside.length > 0 ? Math.min(...beside.map((d) => d.v)) : Infinity;
  const [across, solid] = [p(3), (v: number) => (v < free - SAME ? r.solidFeed : r.feed)];
  for (let k = 1; k <= count; k += 1) {
    const depth = r.top - ((r.top - place.v) * k) / count;
    const purpose = p(step, pass + k);
    if (k === 1) {
      const first = free < r.top && depth < free - SAME ? Math.max(depth, free) : depth;
      cutter.link(
        { u: place.u, v: first },
        { gap: r.clearance, feed: solid(first), out: across, down: across, enter: purpose },
      );
    } else if (cutter.at.v > free + SAME && depth < free - SAME) cutter.feed({ u: place.u, v: free }, r.feed, purpose);
    cutter.feed({ u: place.u, v: depth }, solid(depth), purpose);
    if (k < count) cutter.feed({ u: place.u, v: Math.min(r.top, depth + CHIP_BREAK) }, r.feed, purpose);
  }
  cutter.dwell(r.dwell, r.feed, p(2));
}

/**
 * Between two plunges no farther apart than the level part of the edge, no stock remains above the higher one. Stock
 * behind a plunge that is no higher was cleared with that one.
 */
function clearBeside(cutter: Cutter, { level }: Spacing, place: Flat, done: readonly Flat[]): void {
  for (const side of [-1, 1]) {
    const beside = done
      .map((d) => ({ v: d.v, away: (d.u - place.u) * side }))
      .filter((d) => d.away >= 0 && d.away <= level + SAME);
    let nearer = Infinity;
    for (const d of beside.sort((a, b) => a.away - b.away)) {
      const v = Math.max(d.v, place.v);
      if (nearer <= v) continue;
      nearer = Math.min(nearer, d.v);
      cutter.frontier.lower({ kind: "line", from: { u: place.u + side * d.away, v }, to: { u: place.u, v } });
    }
  }
}

/** Step 2: retracts from the plunge, straight, or at an angle to a side freed by an earlier one as deep. */
function retract(cutter: Cutter, r: PlungeRough, place: Flat, done: readonly Flat[]): void {
  const free = done.filter((d) => d.v < place.v + SAME && Math.abs(d.u - place.u) < r.spacing.level + SAME);
  const sides = [-1, 1].filter((side) => free.some((d) => (d.u - place.u) * side > SAME));
  if (r.aslant && sides.length > 0) {
    const [side = 1] = sides;
    const room = Math.max(...free.map((d) => (d.u - place.u) * side));
    const by = Math.min(ASLANT, room, r.top - place.v);
    cutter.feed({ u: place.u + side * by, v: place.v + by }, r.feed, p(2));
  }
  const out = p(2);
  cutter.link({ u: cutter.at.u, v: r.top }, { gap: r.clearance, feed: r.feed, out, down: out, enter: out });
}

/**
 * Cuts the residual material between the plunges on inclined and round walls, and on a floor for a round edge: one cut
 * down each side.
 */
function alongWalls(cutter: Cutter, r: PlungeRough, { from, to, floor }: Basin): void {
  const e = r.ground.envelope;
  const cut = (path: readonly FlatSegment[], away: 1 | -1) => {
    const [first] = path;
    if (!first) return;
    const purpose = p(5);
    const link = { gap: r.clearance, feed: r.feed, out: purpose, down: purpose, enter: purpose };
    cutter.link(first.from, link);
    cutter.along(path, () => ({ feed: r.feed, purpose }));
    const beside = away > 0 ? r.room.to - cutter.at.u : cutter.at.u - r.room.from;
    cutter.leave(
      liftUnder(r.top, cutter.at.v, r.clearance),
      away,
      e,
      r.feed,
      purpose,
      Math.min(r.clearance, reachOfStep(r.spacing), beside),
    );
    cutter.link({ u: cutter.at.u, v: r.top }, link);
  };
  const left = cutter.frontier.stockAbove(e, { from, to: floor.to }, LEFT);
  if (left && left.to > left.from + SAME)
    cut(
      pathAlong(e, left.from, left.to).map((s) => s.segment),
      1,
    );
  const right = cutter.frontier.stockAbove(e, { from: floor.to, to }, LEFT);
  if (right && right.to > right.from + SAME)
    cut(
      pathAlong(e, right.from, right.to)
        .map((s) => flat.reversed(s.segment))
        .reverse(),
      -1,
    );
}
