import type { Plan } from "../kernel/plan/plan.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { SAME } from "../kernel/tolerance.ts";
import type { MissingCrest } from "./simulation.ts";

/** A crest lower by more than this share of the thread depth is missing. */
const MISSING_SHARE = 0.1;
/** Share of a thread that may lack its crest: a chamfer at its start, a relief at its end. */
const MOST_MISSING = 0.5;
/** Sample places per pitch, and at most in total. */
const PLACES = { perPitch: 16, most: 20_000 } as const;

/** A point along a thread (u) and out of its material (v). */
type Place = readonly [u: number, v: number];

/** Stock height over the crest, for equal stretches of it; -Infinity where there is no stock. */
function heightsOver(
  crest: readonly Place[],
  stock: readonly (readonly Place[])[],
  [from, each, count]: readonly [number, number, number],
) {
  const over = new Float64Array(count).fill(-Infinity);
  let piece = 0;
  const crestAt = (u: number): number => {
    while (piece > 0 && (crest[piece]?.[0] ?? 0) > u) piece -= 1;
    while (piece < crest.length - 2 && (crest[piece + 1]?.[0] ?? 0) < u) piece += 1;
    const [a, b] = [crest[piece] as Place, crest[piece + 1] as Place];
    return a[1] + ((b[1] - a[1]) * (u - a[0])) / (b[0] - a[0]);
  };
  const look = (u: number, v: number, i: number) => {
    if (i >= 0 && i < count) over[i] = Math.max(over[i] as number, v - crestAt(u));
  };
  for (const ring of stock)
    ring.forEach((p, i) => {
      const q = ring[(i + 1) % ring.length] as Place;
      const [a, b] = p[0] <= q[0] ? [p, q] : [q, p];
      const [first, last] = [
        Math.max(0, Math.floor((a[0] - from) / each)),
        Math.min(count - 1, Math.floor((b[0] - from) / each)),
      ];
      for (let k = first; k <= last; k += 1)
        for (const u of [Math.max(a[0], from + k * each), Math.min(b[0], from + (k + 1) * each)])
          look(u, b[0] - a[0] < SAME ? Math.max(a[1], b[1]) : a[1] + ((b[1] - a[1]) * (u - a[0])) / (b[0] - a[0]), k);
    });
  return over;
}

/**
 * The missing crest height of a thread before its first pass: the shaft is too thin, or the bore too wide. Where
 * grooves exist already, the material beside them counts.
 */
export function crestMissing({ thread, openSide }: Plan, stock: readonly Ring[]): MissingCrest | null {
  const depth = thread?.depths.at(-1);
  if (!thread || depth === undefined || thread.crest.length < 2) return null;
  const inFace = Math.abs(openSide.z) > Math.abs(openSide.r);
  const place = (p: Pt): Place => [inFace ? p.r : p.z, p.z * openSide.z + p.r * openSide.r];
  const points = [...thread.crest].sort((a, b) => place(a)[0] - place(b)[0]);
  const [from, to] = [place(points[0] as Pt)[0], place(points.at(-1) as Pt)[0]];
  const each = Math.max(thread.pitch / PLACES.perPitch, (to - from) / PLACES.most);
  const count = Math.max(1, Math.floor((to - from) / each));
  const over = heightsOver(
    points.map(place),
    stock.map((ring) => ring.map(place)),
    [from, (to - from) / count, count],
  );
  const beside = Math.ceil(thread.pitch / 2 / each);
  const highest = Array.from(over, (_, i) => Math.max(...over.subarray(Math.max(0, i - beside), i + beside + 1)));
  const missing = highest.map((h, i) => ({ i, by: -h })).filter(({ by }) => by > MISSING_SHARE * depth + SAME);
  const known = missing.filter(({ by }) => Number.isFinite(by)).sort((a, b) => a.by - b.by);
  const middle = known[Math.floor(known.length / 2)];
  if (missing.length <= MOST_MISSING * count || !middle) return null;
  const u = from + ((middle.i + 0.5) * (to - from)) / count;
  const on = points.findIndex((p, i) => i > 0 && place(p)[0] >= u);
  const [a, b] = [points[Math.max(0, on - 1)] as Pt, points[Math.max(1, on)] as Pt];
  const k = (u - place(a)[0]) / (place(b)[0] - place(a)[0]);
  return { missing: middle.by, inFace, z: a.z + k * (b.z - a.z), r: a.r + k * (b.r - a.r) };
}
