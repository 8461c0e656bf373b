import { pathAlong, type Interval } from "../envelope.ts";
import { flat, type Flat, type FlatSegment } from "../flat.ts";
import { SAME } from "../tolerance.ts";
import type { Purpose } from "../track.ts";
import type { Feeds } from "./feeds.ts";
import { FAR, type Ground } from "./ground.ts";
import type { Cutter } from "./link.ts";
import { containing, deepestIn, RECESS_CLEARANCE } from "./valley.ts";

const { reversed, shifted } = flat;

export interface RecessRough {
  readonly ground: Ground;
  readonly span: Interval;
  readonly top: number;
  /** The start point stands in front of the opening, so that there is something to cut there too. */
  readonly inFront: boolean;
  readonly passes: number;
  readonly infeed: number;
  /** Shortening per pass on the side where it ends, mm. */
  readonly offset: number;
  readonly oneWay: boolean;
  readonly feeds: Feeds;
}

type Side = "left" | "right";

const purpose = (step: number, pass?: number, plunging = false): Purpose => ({
  phase: "rough",
  run: "rough",
  step,
  ...(pass !== undefined && { pass }),
  ...(plunging ? { plunging: true as const } : {}),
});

/** The printed steps 1 to 7 of roughing a recess: plunge, cut sideways, plunge …, and at the end one cut along each wall. */
export function roughRecess(cutter: Cutter, r: RecessRough): void {
  const e = r.ground.envelope;
  const level = (i: number) => r.top - i * r.infeed;
  const centre = deepestIn(e, level(r.passes), r.span);
  const valley = (i: number): Interval => containing(e, level(i), r.span, centre);
  const shortened = { left: 0, right: 0 };

  let here = valley(1);
  cutter.link({ u: here.from, v: level(1) }, linked(r, 1, purpose(1, 1, true)));
  for (let i = 1; i <= r.passes; i++) {
    const side: Side = r.oneWay || i % 2 === 1 ? "right" : "left";
    if (i > 1) shortened[side] += r.offset;
    const end = side === "right" ? Math.max(here.from, here.to - shortened.right) : Math.min(here.to, here.from + shortened.left);
    cutter.feed({ u: end, v: level(i) }, r.feeds.rough, purpose(2, i));
    if (i === r.passes) break;
    const next = valley(i + 1);
    if (r.oneWay) {
      cutter.feed({ u: end, v: level(i) + RECESS_CLEARANCE }, r.feeds.rough, purpose(4, i));
      cutter.link({ u: here.from, v: level(i) }, linked(r, 4, purpose(4, i)));
      down(cutter, pathAlong(e, here.from, next.from).map((s) => s.segment), { u: next.from, v: level(i + 1) }, r, i + 1);
    } else beside(cutter, r, side, { here, next, shortened }, i + 1);
    here = next;
  }
  alongWalls(cutter, r, here, shortened);
}

const linked = (r: RecessRough, step: number, enter: Purpose) => ({
  gap: RECESS_CLEARANCE,
  feed: r.feeds.plunge,
  out: purpose(step),
  down: purpose(step),
  enter,
});

/** From a level of a valley to the next one, with what the passes are shortened on either side, mm. */
interface Descent {
  readonly here: Interval;
  readonly next: Interval;
  readonly shortened: Readonly<Record<Side, number>>;
}

/** Down beside a wall, apart from it by what the passes are shortened there; where it cannot be followed, sideways and down. */
function beside(cutter: Cutter, r: RecessRough, side: Side, { here, next, shortened }: Descent, pass: number) {
  const e = r.ground.envelope;
  const wall = side === "right"
    ? pathAlong(e, next.to, here.to).map((s) => shifted(reversed(s.segment), { u: -shortened.right, v: 0 })).reverse()
    : pathAlong(e, here.from, next.from).map((s) => shifted(s.segment, { u: shortened.left, v: 0 }));
  const wanted = side === "right" ? next.to - shortened.right : next.from + shortened.left;
  const target = { u: Math.min(Math.max(wanted, next.from), next.to), v: r.top - pass * r.infeed };
  const stands = side === "right" ? here.to - shortened.right : here.from + shortened.left;
  const fits = Math.abs(target.u - wanted) < SAME && Math.abs(cutter.at.u - stands) < SAME;
  down(cutter, fits ? wall : [], target, r, pass);
}

/** Along a wall to the next level; without a wall to follow, sideways first and then straight down. */
function down(cutter: Cutter, wall: readonly FlatSegment[], target: Flat, r: RecessRough, pass: number) {
  const p = purpose(5, pass, true);
  if (wall.length === 0) cutter.feed({ u: target.u, v: cutter.at.v }, r.feeds.plunge, p);
  cutter.along(wall, () => ({ feed: r.feeds.plunge, purpose: p }));
  cutter.feed(target, r.feeds.plunge, p);
}

/** What the shortening left: one plunging cut along each wall down to the floor, and the rest of the floor beside it. */
function alongWalls(cutter: Cutter, r: RecessRough, floor: Interval, shortened: Record<Side, number>) {
  const e = r.ground.envelope;
  const p = purpose(7);
  const bottom = r.top - r.passes * r.infeed;
  const open = containing(e, r.top, { from: r.span.from - FAR, to: r.span.to + FAR }, (floor.from + floor.to) / 2);
  const left = r.inFront ? open.from : Math.max(open.from, r.ground.start.u);
  const right = r.inFront ? open.to : Math.min(open.to, r.ground.end.u);
  const out = () => cutter.link({ u: cutter.at.u, v: r.top + RECESS_CLEARANCE }, linked(r, 7, p));
  const cut = (begin: number, path: readonly FlatSegment[], end: number, along: number, away: 1 | -1) => {
    const from = path[0]?.from ?? { u: begin, v: r.top };
    cutter.link({ u: begin, v: Math.max(r.top, from.v) }, linked(r, 7, { ...p, plunging: true }));
    cutter.along(path, () => ({ feed: r.feeds.plunge, purpose: { ...p, plunging: true } }));
    cutter.feed({ u: end, v: bottom }, r.feeds.plunge, { ...p, plunging: true });
    cutter.feed({ u: along, v: bottom }, r.feeds.rough, p);
    const room = away > 0 ? floor.to - cutter.at.u : cutter.at.u - floor.from;
    cutter.leave(RECESS_CLEARANCE, away, e, r.feeds.rough, p, room);
    out();
  };
  cutter.feed({ u: cutter.at.u, v: bottom + Math.min(r.infeed, RECESS_CLEARANCE) }, r.feeds.rough, p);
  out();
  cut(left, pathAlong(e, left, floor.from).map((s) => s.segment), floor.from, Math.min(floor.to, floor.from + shortened.left), 1);
  const wall = pathAlong(e, floor.to, right).map((s) => reversed(s.segment)).reverse();
  cut(right, wall, floor.to, Math.max(floor.from, floor.to - shortened.right), -1);
}
