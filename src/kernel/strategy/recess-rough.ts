import { lowest, pathAlong, type Interval } from "../reach/envelope.ts";
import { flat, type Flat, type FlatSegment } from "../geometry/flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../plan/track.ts";
import type { Feeds } from "./feeds.ts";
import type { TipEnvelope } from "./tip-envelope.ts";
import { isFalling } from "./levels.ts";
import type { Cutter } from "./link.ts";
import { heightOf, type Rim, type RecessSection, sectionsOf } from "./sections.ts";
import { liftUnder, RECESS_CLEARANCE } from "./valley.ts";

const { reversed, shifted } = flat;

export interface RecessRough {
  readonly ground: TipEnvelope;
  /** Range of the tip: between the walls that close the area, or up to the contact at the ends of the contour. */
  readonly area: Interval;
  readonly top: number;
  readonly passes: number;
  readonly infeed: number;
  /** Shortening per pass on its end side, mm. */
  readonly offset: number;
  readonly oneWay: boolean;
  readonly feeds: Feeds;
}

type Side = "left" | "right";
/** Accumulated shortening of passes on either side of a section, mm. */
type Shortened = Readonly<Record<Side, number>>;

const purpose = (step: number, pass?: number, plunging = false): Purpose => ({
  phase: "rough",
  run: "rough",
  step,
  ...(pass !== undefined && { pass }),
  ...(plunging ? { plunging: true as const } : {}),
});

/**
 * The printed steps 1 to 7 of roughing a recess: plunge, cut sideways, plunge …, and at the end one cut along each
 * wall. A contour with several valleys is cut section by section.
 */
export function roughRecess(cutter: Cutter, r: RecessRough): void {
  for (const section of sectionsOf(r.ground.envelope, r, r.area))
    roughSection(cutter, r, section, { left: 0, right: 0 });
}

function roughSection(cutter: Cutter, r: RecessRough, s: RecessSection, before: Shortened): void {
  const shortened = { ...before };
  const e = r.ground.envelope;
  s.levels.forEach((here, k) => {
    const pass = s.first + k;
    const side: Side = r.oneWay || pass % 2 === 1 ? "right" : "left";
    const height = heightOf(r, pass);
    if (k === 0) {
      const begin =
        side === "right"
          ? Math.min(here.to, here.from + shortened.left)
          : Math.max(here.from, here.to - shortened.right);
      cutter.link({ u: begin, v: height }, linked(r, 1, purpose(1, pass, true)));
    }
    if (pass > 1) shortened[side] += r.offset;
    const next = s.levels[k + 1];
    const end = endOf(cutter, side, { here, next: s.levels.at(-1) ?? here, shortened });
    const began = cutter.at.u;
    cutter.feed({ u: end, v: height }, r.feeds.rough, purpose(2, pass));
    if (!next) return;
    if (r.oneWay) {
      cutter.feed({ u: end, v: height + liftUnder(r.top, height) }, r.feeds.rough, purpose(4, pass));
      const begin = Math.min(here.to, here.from + before.left);
      cutter.link({ u: begin, v: height }, linked(r, 4, purpose(4, pass)));
      const wall = before.left > 0 ? [] : pathAlong(e, here.from, next.from).map((x) => x.segment);
      descend(cutter, wall, { u: Math.min(next.to, next.from + before.left), v: heightOf(r, pass + 1) }, r, pass + 1);
    } else descendBesideWall(cutter, r, side, { here, next, shortened, began }, pass + 1);
  });
  const last = s.inner.length - 1;
  s.inner.forEach((part, i) =>
    roughSection(cutter, r, part, { left: i === 0 ? shortened.left : 0, right: i === last ? shortened.right : 0 }),
  );
  if (s.levels.length === 0) alongFloor(cutter, r, s);
  else if (last < 0) alongWalls(cutter, r, s, shortened);
}

const linked = (r: RecessRough, step: number, enter: Purpose) => ({
  gap: RECESS_CLEARANCE,
  feed: r.feeds.plunge,
  out: purpose(step),
  down: purpose(step),
  enter,
});

/** A level of a valley and the next one, with the shortening of the passes on either side, mm. */
interface Descent {
  readonly here: Interval;
  readonly next: Interval;
  readonly shortened: Shortened;
}

/**
 * End of a pass: in front of its wall by the shortening, but not before the deepest level (`next`), above which nothing
 * may be left for a plunge. If the shortening uses up the pass, it stays where it plunged: on the way back it would cut
 * the residual material of all earlier passes on the other side at once.
 */
function endOf({ at }: Cutter, side: Side, { here, next, shortened }: Descent): number {
  return side === "right"
    ? Math.max(at.u, Math.min(here.to, Math.max(here.to - shortened.right, next.from)))
    : Math.min(at.u, Math.max(here.from, Math.min(here.from + shortened.left, next.to)));
}

/**
 * Feeds down along a wall, at a distance equal to the shortening; where it cannot be followed, sideways and down. A
 * used-up pass goes straight down, or along the wall there.
 */
function descendBesideWall(
  cutter: Cutter,
  r: RecessRough,
  side: Side,
  { here, next, shortened, began }: Descent & { readonly began: number },
  pass: number,
) {
  const e = r.ground.envelope;
  const wall =
    side === "right"
      ? pathAlong(e, next.to, here.to)
          .map((s) => shifted(reversed(s.segment), { u: -shortened.right, v: 0 }))
          .reverse()
      : pathAlong(e, here.from, next.from).map((s) => shifted(s.segment, { u: shortened.left, v: 0 }));
  const wanted = side === "right" ? next.to - shortened.right : next.from + shortened.left;
  const stands = side === "right" ? here.to - shortened.right : here.from + shortened.left;
  const { u } = cutter.at;
  // Beyond the start of this pass is residual material of earlier passes: there is no way across it.
  const usedUp = side === "right" ? wanted < Math.max(began, next.from) : wanted > Math.min(began, next.to);
  const target = { u: Math.min(Math.max(usedUp ? u : wanted, next.from), next.to), v: heightOf(r, pass) };
  if (side === "right" ? u > stands + SAME : u < stands - SAME) {
    const under =
      u > next.to
        ? pathAlong(e, next.to, u)
            .map((s) => reversed(s.segment))
            .reverse()
        : u < next.from
          ? pathAlong(e, u, next.from).map((s) => s.segment)
          : [];
    return descend(cutter, under, { u: Math.min(Math.max(u, next.from), next.to), v: target.v }, r, pass);
  }
  // A shoulder between the two levels is not a wall: it is left to the cut along the wall.
  const steep = wall.every((s) => isFalling(s) || Math.abs(s.to.u - s.from.u) < SAME);
  const fits = steep && Math.abs(target.u - wanted) < SAME && Math.abs(cutter.at.u - stands) < SAME;
  descend(cutter, fits ? wall : [], target, r, pass);
}

/** Feeds along a wall to the next level; without one, sideways first and then straight down. */
function descend(cutter: Cutter, wall: readonly FlatSegment[], target: Flat, r: RecessRough, pass: number) {
  const p = purpose(5, pass, true);
  if (wall.length === 0) cutter.feed({ u: target.u, v: cutter.at.v }, r.feeds.plunge, p);
  cutter.along(wall, () => ({ feed: r.feeds.plunge, purpose: p }));
  cutter.feed(target, r.feeds.plunge, p);
}

const p = purpose(7);
const plunging: Purpose = { ...p, plunging: true };
/** A cut along a wall uses the plunging feed wherever it falls. */
const alongWall = (r: RecessRough) => (s: FlatSegment) =>
  isFalling(s) ? { feed: r.feeds.plunge, purpose: plunging } : { feed: r.feeds.rough, purpose: p };
const retractToTop = (cutter: Cutter, r: RecessRough) => cutter.link({ u: cutter.at.u, v: r.top }, linked(r, 7, p));
/** Links to the start of the cut along a wall. */
const onRim = (cutter: Cutter, r: RecessRough, rim: Rim, wall: readonly FlatSegment[]) =>
  cutter.link({ u: rim.u, v: Math.max(rim.v, wall[0]?.from.v ?? rim.v) }, linked(r, 7, plunging));

/** Cuts a valley without levels, along its floor. */
function alongFloor(cutter: Cutter, r: RecessRough, s: RecessSection) {
  const e = r.ground.envelope;
  const floor = pathAlong(e, s.left.u, s.right.u).map((x) => x.segment);
  onRim(cutter, r, s.left, floor);
  cutter.along(floor, alongWall(r));
  cutter.leave(liftUnder(r.top, cutter.at.v), -1, e, r.feeds.rough, p, s.right.u - s.left.u);
  retractToTop(cutter, r);
}

/**
 * Cuts the residual material of levels and shortening: the rest below the last level, one plunging cut down each wall,
 * and the adjoining floor.
 */
function alongWalls(cutter: Cutter, r: RecessRough, s: RecessSection, shortened: Shortened) {
  const e = r.ground.envelope;
  const floor = s.levels.at(-1) as Interval;
  const pass = s.first + s.levels.length - 1;
  const bottom = heightOf(r, pass);
  const [a, b] = [Math.min(floor.to, floor.from + shortened.left), Math.max(floor.from, floor.to - shortened.right)];
  const deeper = lowest(e, floor.from, floor.to) < bottom - SAME;
  const segments = (from: number, to: number) => (to > from + SAME ? pathAlong(e, from, to).map((x) => x.segment) : []);
  const backwards = (path: readonly FlatSegment[]) => path.map(reversed).reverse();
  if (deeper) {
    const path = cutter.at.u > (a + b) / 2 ? backwards(segments(a, b)) : segments(a, b);
    const how = (x: FlatSegment) =>
      isFalling(x)
        ? { feed: r.feeds.plunge, purpose: purpose(5, undefined, true) }
        : { feed: r.feeds.rough, purpose: purpose(2) };
    cutter.along(path, how);
  }
  const cut = (away: 1 | -1, rim: Rim, wall: readonly FlatSegment[], rest: readonly FlatSegment[]) => {
    const [foot, end] = away > 0 ? [floor.from, a] : [floor.to, b];
    onRim(cutter, r, rim, wall);
    cutter.along(wall, alongWall(r));
    cutter.feed({ u: foot, v: bottom }, r.feeds.plunge, plunging);
    if (deeper) cutter.along(rest, alongWall(r));
    else cutter.feed({ u: end, v: bottom }, r.feeds.rough, p);
    const room = away > 0 ? floor.to - cutter.at.u : cutter.at.u - floor.from;
    cutter.leave(liftUnder(r.top, cutter.at.v), away, e, r.feeds.rough, p, room);
    retractToTop(cutter, r);
  };
  cutter.feed({ u: cutter.at.u, v: cutter.at.v + Math.min(r.infeed, RECESS_CLEARANCE) }, r.feeds.rough, p);
  retractToTop(cutter, r);
  // A tool as wide as the groove has cut both walls.
  if (s.right.u - s.left.u <= SAME) return;
  const onward = pathAlong(e, s.left.u, floor.from).map((x) => x.segment);
  cut(1, s.left, onward, segments(floor.from, a));
  const back = backwards(pathAlong(e, floor.to, s.right.u).map((x) => x.segment));
  cut(-1, s.right, back, backwards(segments(b, floor.to)));
}
