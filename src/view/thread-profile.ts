import type { ThreadPlan } from "../kernel/plan/plan.ts";

/** The chip of one pass: the part of the groove that no earlier pass removed, as a closed line of the drawing. */
export interface ThreadChip {
  /** From 1. */
  readonly pass: number;
  readonly points: readonly ProfilePoint[];
}

/** x along the thread in cutting direction, y into the material, both in pixels. */
export interface ProfilePoint {
  readonly x: number;
  readonly y: number;
}

/** One groove of a thread in section: the crest as a line, the chips from the first to the last pass. */
export interface ThreadProfile {
  readonly width: number;
  readonly height: number;
  /** Height of the crest. */
  readonly crest: number;
  readonly chips: readonly ThreadChip[];
}

/** Limit of drawn passes. More passes are drawn in this many steps, because single ones could not be told apart. */
const MOST = 40;
const SAMPLES = 160;
const EDGE = 6;

/** Depth of a groove at a place, with the tip at `tip`, `deep` mm below the crest; 0 outside the groove. */
function depthAt(side: ThreadPlan["side"], u: number, tip: number, deep: number): number {
  const at = u - tip;
  for (let i = 1; i < side.length; i += 1) {
    const [a, b] = [side[i - 1], side[i]];
    if (!a || !b || at < a.u || at > b.u) continue;
    const up = b.u > a.u ? a.v + ((b.v - a.v) * (at - a.u)) / (b.u - a.u) : a.v;
    return Math.max(0, deep - up);
  }
  return 0;
}

/** Draws the groove of a thread and the chip of each pass in it; null when there is none. */
export function threadProfile(
  { depths, slope, side, pitch }: ThreadPlan,
  width: number,
  height: number,
): ThreadProfile | null {
  const depth = depths.at(-1);
  if (depth === undefined || side.length < 2 || !(depth > 0)) return null;
  const every = Math.ceil(depths.length / MOST);
  const drawn = depths
    .map((deep, i) => ({ deep, pass: i + 1 }))
    .filter(({ pass }) => pass % every === 0 || pass === depths.length);
  const flank = Math.max(...[side[0], side.at(-1)].map((p) => (p && p.v > 0 ? Math.abs(p.u) / p.v : 1)));
  const half = Math.max(pitch / 2, depth * flank) * 1.1;
  const scale = Math.min((width - 2 * EDGE) / (2 * half), (height - 4 * EDGE) / depth);
  const crest = (height - depth * scale) / 2;
  const places = Array.from({ length: SAMPLES + 1 }, (_, i) => -half + (2 * half * i) / SAMPLES);
  const place = (u: number, deep: number): ProfilePoint => ({ x: width / 2 + u * scale, y: crest + deep * scale });
  let before = places.map(() => 0);
  const chips = drawn.map(({ deep, pass }): ThreadChip => {
    const tip = -(depth - deep) * slope;
    const now = places.map((u, i) => Math.max(before[i] ?? 0, depthAt(side, u, tip, deep)));
    const taken = places
      .map((u, i) => ({ u, i }))
      .filter(({ i }) => [i - 1, i, i + 1].some((k) => (now[k] ?? 0) > (before[k] ?? 0)));
    const under = taken.map(({ u, i }) => place(u, now[i] ?? 0));
    const over = taken.map(({ u, i }) => place(u, before[i] ?? 0)).reverse();
    before = now;
    return { pass, points: [...over, ...under] };
  });
  return { width, height, crest, chips };
}
