import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { radians } from "../../kernel/units.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Chain, ElementMark } from "../types.ts";

/** A part of the chain below the level of its surroundings: a groove or a valley, radial or in a face. */
export interface Pocket extends Chain {
  /** The axis along which it is deep: "r" in a cylinder, "z" in a face. */
  readonly axis: "r" | "z";
  /** Indices of its first and its last element in the chain. */
  readonly first: number;
  readonly last: number;
  /** Height of its mouth. */
  readonly level: number;
  /** Pockets in its floor. */
  readonly inner: readonly Pocket[];
}

/** Steps across a pocket, mm. */
const FINE = 0.1;
/** Shallower ones are no pockets, mm. */
const SHALLOWEST = 0.02;

/** Every point of a chain at which it turns up or down. */
const heightsOf = (segments: readonly Segment[], axis: Pocket["axis"]): readonly number[] => [
  segments[0]?.from[axis] ?? 0,
  ...segments.map((s) => s.to[axis]),
];

/** The pockets of a chain, from the front to the rear. */
export function pocketsOf(
  chain: Chain,
  axis: Pocket["axis"],
  [from, to] = [0, chain.segments.length],
): readonly Pocket[] {
  const heights = heightsOf(chain.segments, axis);
  const found: Pocket[] = [];
  const before: number[] = [];
  for (let i = from; i <= to; i += 1) before[i] = Math.max(before[i - 1] ?? -Infinity, heights[i] ?? 0);
  const behind: number[] = [];
  for (let i = to; i >= from; i -= 1) behind[i] = Math.max(behind[i + 1] ?? -Infinity, heights[i] ?? 0);
  const levelAt = (i: number) => Math.min(before[i] ?? 0, behind[i] ?? 0);
  for (let i = from; i <= to; i += 1) {
    const level = levelAt(i);
    if (level - (heights[i] ?? 0) < SAME) continue;
    let end = i;
    while (end < to && level - (heights[end + 1] ?? 0) >= SAME) end += 1;
    const pocket = pocketBetween(chain, axis, [i - 1, end], level);
    if (pocket) found.push(pocket);
    i = end;
  }
  return found;
}

/** The pocket of the elements `first` to `last`, cut at the level of its mouth. */
function pocketBetween(
  chain: Chain,
  axis: Pocket["axis"],
  [first, last]: readonly [number, number],
  level: number,
): Pocket | null {
  const segments = chain.segments.slice(first, last + 1);
  const marks = chain.marks.slice(first, last + 1);
  const heights = heightsOf(segments, axis);
  if (level - Math.min(...heights) < SHALLOWEST) return null;
  const [a, b] = [segments[0], segments.at(-1)];
  if (!a || !b) return null;
  segments[0] = below(a, axis, level, "to");
  segments[segments.length - 1] = below(segments.at(-1) ?? b, axis, level, "from");
  const lowest = heights
    .map((h, i) => ({ h, i }))
    .filter(({ h, i }) => h <= (heights[i - 1] ?? Infinity) && h <= (heights[i + 1] ?? Infinity));
  const [floorFrom, floorTo] = [lowest[0]?.i ?? 0, lowest.at(-1)?.i ?? 0];
  const inner = floorTo - floorFrom > 2 ? pocketsOf(chain, axis, [first + floorFrom, first + floorTo]) : [];
  return { axis, first, last, level, segments, marks, inner };
}

/** Slope at which the usual pointed insert descends (35°, set at 93°), and the share of a valley that it reaches. */
const [DESCENT, LEAST_REACHED] = [Math.tan(radians(180 - 93 - 35)), 0.9];

/**
 * Whether a turning tool that comes from the front reaches nearly all of a pocket. Others are grooves: a turning tool
 * leaves the wall in front, which a blade cuts from the mouth down anyway.
 */
export const isValley = perObject(({ segments, axis, level }: Pocket): boolean => {
  const across = axis === "r" ? "z" : "r";
  const points = part.flattenedChain(segments, CHORD);
  let [reach, reached, all] = [level, 0, 0];
  points.slice(1).forEach((to, i) => {
    const from = points[i] ?? to;
    const width = Math.abs(to[across] - from[across]);
    const steps = Math.ceil(width / FINE);
    for (let n = 0; n < steps; n += 1) {
      const floor = from[axis] + ((to[axis] - from[axis]) * (n + 0.5)) / steps;
      reach = Math.max(floor, reach - (DESCENT * width) / steps);
      reached += level - reach;
      all += level - floor;
    }
  });
  return reached >= LEAST_REACHED * all;
});

/** The piece of a wall below a level, from its end `keep` on. */
function below(s: Segment, axis: Pocket["axis"], level: number, keep: "from" | "to"): Segment {
  const other = keep === "to" ? "from" : "to";
  if (s[other][axis] <= level + SAME) return s;
  const far = 10_000;
  const along = axis === "r" ? part.line(at(-far, level), at(far, level)) : part.line(at(level, -far), at(level, far));
  // The circle of an arc crosses the level twice.
  const crossing = part
    .meetings(along, s)
    .filter((p) => part.apart(p, part.nearestOn(s, p)) < SAME)
    .toSorted((p, q) => part.apart(p, s[keep]) - part.apart(q, s[keep]))[0];
  return crossing ? { ...s, [other]: crossing } : s;
}

/** Order of pockets from the front to the rear, the outer ones first. */
export const fromTheFront = (a: Pocket, b: Pocket): number => a.first - b.first || b.last - a.last;

/** A way over pockets that overlap, from the mouth of the first to that of the last. */
interface Bridge extends Pick<Pocket, "first" | "last"> {
  readonly points: readonly Pt[];
}

/**
 * The ways over pockets, from the front to the rear. An undercut of form F is two pockets, in the cylinder and in the
 * face, that overlap: their mouths meet in the corner that it undercuts.
 */
function bridgesOver({ segments }: Chain, pockets: readonly Pocket[]): readonly Bridge[] {
  const bridges: Bridge[] = [];
  let before: Pocket | null = null;
  for (const pocket of pockets.toSorted(fromTheFront)) {
    const { first, last, segments: own } = pocket;
    const [from, to] = [own[0]?.from, own.at(-1)?.to];
    const bridge = bridges.at(-1);
    if (!from || !to || (bridge && last < bridge.last)) continue;
    const [shared, end] = [segments[first]?.to, bridge?.points.at(-1)];
    const isBehind = shared && end && part.apart(from, shared) > part.apart(end, shared) + SAME;
    if (
      bridge &&
      before &&
      before.axis !== pocket.axis &&
      (first < bridge.last || (first === bridge.last && isBehind))
    ) {
      const [r, z] = pocket.axis === "z" ? [before, pocket] : [pocket, before];
      const points = [...bridge.points.slice(0, -1), at(z.level, r.level), to];
      bridges[bridges.length - 1] = { first: bridge.first, last, points };
    } else bridges.push({ first, last, points: [from, to] });
    before = pocket;
  }
  return bridges;
}

/** A chain with straight lines over some of its pockets. */
export function bridgedOver(chain: Chain, pockets: readonly Pocket[]): Chain {
  const segments: Segment[] = [];
  const marks: ElementMark[] = [];
  const add = (s: Segment, mark: ElementMark) => {
    if (part.apart(s.from, s.to) < SAME) return;
    segments.push(s);
    marks.push(mark);
  };
  const bridges = bridgesOver(chain, pockets);
  chain.segments.forEach((s, i) => {
    const mark = chain.marks[i] ?? { row: "" };
    const starts = bridges.find(({ first }) => first === i);
    const ends = bridges.find(({ last }) => last === i);
    if (bridges.some(({ first, last }) => first < i && i < last)) return;
    const begin = ends?.points.at(-1) ?? s.from;
    const end = starts?.points[0] ?? s.to;
    const bridge = () =>
      starts?.points.slice(1).forEach((to, n) => add(part.line(starts.points[n] ?? end, to), { row: "" }));
    if (starts !== undefined && starts === ends) {
      add({ ...s, to: end }, mark);
      bridge();
      add({ ...s, from: begin }, mark);
    } else {
      add({ ...s, from: begin, to: end }, mark);
      bridge();
    }
  });
  return { segments, marks };
}
