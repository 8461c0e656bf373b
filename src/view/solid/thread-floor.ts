import type { Ring } from "../../kernel/geometry/point.ts";
import { NOTHING, ROUND, SAME } from "../../kernel/tolerance.ts";
import type { ThreadHand } from "../../kernel/time/thread-turns.ts";
import type { ThreadCut } from "./thread-cuts.ts";

/*
 * How deep threads reach. A height is a radius outside and a negative radius in a bore, so that a groove always goes
 * down. The half plane of the stock is at 0; a share of a turn leads on over the operator. Every cut passes every half
 * plane once a turn.
 */

/** Outside, or on the wall of a bore. */
export type ThreadSide = 1 | -1;

/** One side of one cut: its insert as seen from the work, and how it moves. */
interface Pass {
  /** Lower edge of the insert, from left to right: along Z from its tip, and over it, mm. */
  readonly edge: readonly (readonly [z: number, over: number])[];
  /** Where the tip would be at the beginning in the half plane of the stock, mm. */
  readonly z: number;
  readonly height: number;
  /** Way in one turn of the spindle, along Z and in height. */
  readonly along: number;
  readonly rise: number;
  readonly done: number;
  readonly turns: number;
  readonly begun: number;
  readonly stops: boolean;
}

/** A helix in the lead of the thread: a height that grows evenly with the share of the turn, between two shares. */
export interface HelixTrack {
  readonly height: number;
  readonly rise: number;
  readonly from: number;
  readonly to: number;
}

/** A thread: grooves on one side of the work, all of one lead and one hand. */
export interface ThreadFloor {
  readonly side: ThreadSide;
  readonly lead: number;
  /** 1: right-handed as it is drawn. */
  readonly hand: ThreadHand;
  /** Height of the floor at a place of a half plane; Infinity where no groove is. */
  readonly at: (z: number, share: number) => number;
  /** Height cut all round by tools that stood still at the end of the thread; Infinity beside it. */
  readonly stopsAt: (z: number) => number;
  /**
   * What crosses a helix that is at `z` in the half plane of the stock: one height for each turn of each cut that
   * reaches it.
   */
  readonly tracks: (z: number) => readonly HelixTrack[];
  /** Places within one lead at which grooves bend, for a surface of a height: there and a lead farther on. */
  readonly bends: (z: number, height: number) => readonly number[];
  /** Floor of an endless thread in the half plane of the stock, as if every long cut went on for ever. */
  readonly endless: (z: number) => number;
  /** How far grooves reach along Z in a surface of a height; null where they do not reach that deep. */
  readonly reach: (height: number) => readonly [left: number, right: number] | null;
  /** Middle of the cut range. */
  readonly middle: number;
  /** Slope of the grooves to the right, as a share of the way; null if grooves differ, such as at a run-out. */
  readonly slope: number | null;
}

/** The lower edge of a convex outline as seen from the work. */
function edgeOf(outline: Ring, side: ThreadSide): Pass["edge"] {
  const points = outline.map((p) => [p.z, side * p.r] as const);
  // Counter-clockwise, the lower edge runs from left to right; turned over it runs back.
  const list = side === 1 ? points : [...points].reverse();
  const count = list.length,
    out: (readonly [number, number])[] = [];
  const left = list.reduce((best, p, i) => (p[0] < (list[best]?.[0] ?? 0) ? i : best), 0);
  const right = Math.max(...list.map((p) => p[0]));
  for (let k = 0; k < count; k += 1) {
    const p = list[(left + k) % count] as readonly [number, number],
      last = out.at(-1);
    if (last && p[0] <= last[0]) {
      // A wall straight up: its foot is what cuts.
      if (p[0] === last[0] && p[1] < last[1]) out[out.length - 1] = p;
      else break;
    } else out.push(p);
    if (p[0] === right) break;
  }
  return out;
}

/** Height of an edge over its tip at a place beside it; Infinity beyond its ends. */
function edgeAt(edge: Pass["edge"], z: number): number {
  const first = edge[0],
    last = edge.at(-1);
  if (!first || !last || z < first[0] || z > last[0]) return Infinity;
  let [low, high] = [0, edge.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((edge[middle] as readonly [number, number])[0] <= z) low = middle;
    else high = middle;
  }
  const [a, b] = [edge[low] ?? first, edge[high] ?? last],
    wide = b[0] - a[0];
  return wide > 0 ? a[1] + ((b[1] - a[1]) * (z - a[0])) / wide : Math.min(a[1], b[1]);
}

/** The range in which an edge is lower than a height over its tip. */
function edgeWithin(edge: Pass["edge"], over: number): readonly [number, number] | null {
  let [left, right] = [Infinity, -Infinity];
  const add = (z: number) => {
    left = Math.min(left, z);
    right = Math.max(right, z);
  };
  edge.forEach((b, i) => {
    const a = edge[i - 1];
    if (b[1] <= over) add(b[0]);
    if (a && a[1] < over !== b[1] < over && b[1] !== a[1]) add(a[0] + ((b[0] - a[0]) * (over - a[1])) / (b[1] - a[1]));
  });
  return left <= right ? [left, right] : null;
}

const passOf = ({ from, move, done, turns, outline }: ThreadCut, side: ThreadSide): Pass => ({
  edge: edgeOf(outline, side),
  z: from.z,
  height: side * from.r,
  along: (move.to.z - from.z) / turns,
  rise: (side * (move.to.r - from.r)) / turns,
  done,
  turns,
  begun: move.angle / 360,
  stops: move.stops,
});

/** On which side of the work an insert cuts: its body lies away from it. */
export const threadSide = ({ outline }: ThreadCut): ThreadSide => {
  const [low, high] = outline.reduce(([l, h], { r }) => [Math.min(l, r), Math.max(h, r)], [Infinity, -Infinity]);
  return high >= -low ? 1 : -1;
};

/** Whether two cuts belong to one thread: side, lead and hand are the same, and along Z they lie over each other. */
function isOneThread(a: ThreadCut, b: ThreadCut): boolean {
  const ends = ({ from, move: { to } }: ThreadCut) => [Math.min(from.z, to.z), Math.max(from.z, to.z)] as const;
  const [[left, right], [from, to]] = [ends(a), ends(b)];
  return (
    threadSide(a) === threadSide(b) &&
    a.hand === b.hand &&
    Math.abs(a.move.pitch - b.move.pitch) <= ROUND &&
    left < to + SAME &&
    from < right + SAME
  );
}

/**
 * The threads that cuts make; null where some of them run across the spindle, and cannot be drawn. `mirrored`: −1 where
 * the picture is a mirror image, in which a right-handed thread is made left-handed.
 */
export function threadFloors(cuts: readonly ThreadCut[], mirrored: ThreadHand): readonly ThreadFloor[] | null {
  const own = cuts.filter((cut) => cut.turns > 0 && Number.isFinite(cut.turns));
  if (own.some(({ move }) => move.axis !== "z")) return null;
  const threads = own.reduce((all: readonly (readonly ThreadCut[])[], cut) => {
    const near = all.filter((thread) => thread.some((each) => isOneThread(each, cut)));
    return [...all.filter((thread) => !near.includes(thread)), [...near.flat(), cut]];
  }, []);
  return threads.flatMap((thread) => floorOf(thread, mirrored) ?? []);
}

function floorOf(own: readonly ThreadCut[], mirrored: ThreadHand): ThreadFloor | null {
  const first = own[0];
  if (!first) return null;
  const side = threadSide(first),
    hand: ThreadHand = first.hand === mirrored ? 1 : -1;
  const lead = first.move.pitch,
    passes = own.map((cut) => passOf(cut, side));
  // The run-out at the end is a separate, short cut.
  const longest = Math.max(...passes.map((p) => p.turns)),
    main = passes.filter((p) => p.turns > longest / 2);
  const ends = main.flatMap((p) => [p.z, p.z + p.along * p.turns]);
  const slopes = passes.map((p) => p.rise / p.along),
    [slope = 0] = slopes;
  /** How far the turn in which a pass is counts on in one turn of the work. */
  const senseOf = ({ along }: Pass) => (along * hand > 0 ? 1 : -1);
  /** The first and last turn whose insert may lie over a place in the half plane of the stock. */
  const turnsOver = ({ edge, z, along, begun }: Pass, at: number) => {
    const ways = [at - (edge[0]?.[0] ?? 0), at - (edge.at(-1)?.[0] ?? 0)].map((place) => (place - z) / along + begun);
    return [Math.ceil(Math.min(...ways) - ROUND), Math.floor(Math.max(...ways) + ROUND)] as const;
  };
  const over = (p: Pass, at: number, turn: number) => edgeAt(p.edge, at - p.z - p.along * (turn - p.begun));
  const stopped = passes.filter((p) => p.stops && p.done >= p.turns);
  const stopsAt = (z: number) =>
    stopped.reduce(
      (least, p) => Math.min(least, p.height + p.rise * p.turns + edgeAt(p.edge, z - p.z - p.along * p.turns)),
      Infinity,
    );

  const tracksOf = (z: number): HelixTrack[] =>
    passes.flatMap((p) => {
      const [from, to] = turnsOver(p, z),
        sense = senseOf(p),
        out: HelixTrack[] = [];
      for (let turn = from; turn <= to; turn += 1) {
        const height = p.height + over(p, z, turn),
          gone = turn - p.begun;
        if (!Number.isFinite(height)) continue;
        // Turns done at a share t of the turn: gone + sense·t, from 0 up to `done`.
        const [a, b] = [-sense * gone, sense * (p.done - gone)];
        const [begin, last] = [Math.max(0, Math.min(a, b) - ROUND), Math.min(1, Math.max(a, b) + ROUND)];
        if (begin <= last) out.push({ height: height + p.rise * gone, rise: p.rise * sense, from: begin, to: last });
      }
      return out;
    });

  return {
    side,
    lead,
    hand,
    tracks: tracksOf,
    at(z, share) {
      const flat = z - hand * lead * share;
      const helices = tracksOf(flat).reduce(
        (least, t) => (share >= t.from && share <= t.to ? Math.min(least, t.height + t.rise * share) : least),
        Infinity,
      );
      return Math.min(helices, stopsAt(z));
    },
    stopsAt,
    endless: (z) =>
      main.reduce((least, p) => {
        const [from, to] = turnsOver(p, z);
        let low = least;
        for (let turn = from; turn <= to; turn += 1)
          low = Math.min(low, p.height + p.rise * (turn - p.begun) + over(p, z, turn));
        return low;
      }, Infinity),
    bends: (z, height) =>
      main.flatMap((p) => {
        // Heights count at the place of the pass, which on a cone is not where it began.
        const there = p.height + p.rise * ((z - p.z) / p.along),
          cut = edgeWithin(p.edge, height - there);
        if (!cut) return [];
        return [...cut, ...p.edge.flatMap(([at]) => (at > cut[0] && at < cut[1] ? [at] : []))].map((at) => {
          const place = p.z - p.along * p.begun + at;
          return place - lead * Math.floor((place - z) / lead);
        });
      }),
    reach(height) {
      let [left, right] = [Infinity, -Infinity];
      for (const p of passes) {
        const lowest = Math.min(p.height, p.height + p.rise * p.turns),
          within = edgeWithin(p.edge, height - lowest);
        if (!within || p.done < NOTHING) continue;
        left = Math.min(left, Math.min(p.z, p.z + p.along * p.done) + within[0]);
        right = Math.max(right, Math.max(p.z, p.z + p.along * p.done) + within[1]);
      }
      return right - left > SAME ? [left, right] : null;
    },
    middle: (Math.min(...ends) + Math.max(...ends)) / 2,
    slope: slopes.every((each) => Math.abs(each - slope) < ROUND) ? slope : null,
  };
}
