import { part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { FEED_ALONG } from "../material/lines.ts";
import { boundaryIn } from "../material/scan.ts";
import type { SurfaceOrigin, StockSide, Surfaces, Texture } from "../material/surfaces.ts";
import type { TonedSide } from "./tones.ts";

/** Textures by their number; 0 is a surface of unknown origin. */
export const TEXTURE_CODES = [
  null,
  "raw",
  "rough",
  "thread",
  "finished",
] as const satisfies readonly (Texture | null)[];

/** How a piece of a surface looks. */
export interface SideLook {
  readonly texture: Texture;
  /** Which turn of the work left a place, where the feed left marks; null where it left none. */
  readonly turnAt: ((p: Pt) => number) | null;
  /** The tone of a scale that colours it; null without one. */
  readonly tone: number | null;
}

/** The look of a stock's surfaces. */
export interface StockLooks {
  /** Where the look of a straight piece of an outline changes, from its beginning on. */
  readonly changes: (p: Pt, q: Pt) => readonly Pt[];
  /** The look of a straight piece of an outline; null for a cut face, which is no surface of the stock. */
  readonly of: (p: Pt, q: Pt) => SideLook | null;
  /** The visible textures, in the order of `LOOKS`. */
  readonly textures: readonly Texture[];
}

/** Largest distance of a shown outline from that of the stock, mm: simplification and rounding. */
const BESIDE = 0.008;
/** Looks change at corners of the outline when they are no farther from them, mm. */
const CORNER = 0.02;
/** Slices along Z that speed up the search for pieces. */
const SLICES = 128;

/**
 * The look of a place on a surface as two numbers for each corner: the texture's number plus the number of textures for
 * each tone, and the turn.
 */
export const encodedLook = (look: SideLook | null | undefined, p: Pt): readonly [look: number, turn: number] =>
  look
    ? [
        TEXTURE_CODES.indexOf(look.texture) + TEXTURE_CODES.length * (look.tone === null ? 0 : look.tone + 1),
        look.turnAt?.(p) ?? 0,
      ]
    : [0, 0];

const isAlong = ({ way, pitch }: SurfaceOrigin, dz: number, dr: number, long: number) =>
  pitch > 0 && Math.abs(way[0] * dr - way[1] * dz) <= FEED_ALONG * long;

/** A move that runs along a face counts its turns from the axis, another one from where it began. */
const turnsOf =
  ({ pitch, way, from }: SurfaceOrigin) =>
  (p: Pt): number =>
    Math.abs(way[0]) < FEED_ALONG ? p.r / (pitch * Math.abs(way[1])) : (p.z - from) / (pitch * way[0]);

/**
 * The stretch of the piece from `p` to `q` on which an edge of the stock lies, as shares; null if the edge lies beside
 * it or runs backwards.
 */
function shareOn(p: Pt, q: Pt, { z0, r0, z1, r1 }: StockSide): readonly [number, number] | null {
  const [dz, dr] = [q.z - p.z, q.r - p.r],
    long = Math.hypot(dz, dr);
  if ((z1 - z0) * dz + (r1 - r0) * dr <= 0) return null;
  const away = (z: number, r: number) => Math.abs((z - p.z) * dr - (r - p.r) * dz) / long;
  if (away(z0, r0) > BESIDE || away(z1, r1) > BESIDE) return null;
  const share = (z: number, r: number) => ((z - p.z) * dz + (r - p.r) * dr) / (long * long);
  const [from, to] = [Math.max(0, share(z0, r0)), Math.min(1, share(z1, r1))];
  return to > from ? [from, to] : null;
}

const looksLike = (a: SurfaceOrigin, b: SurfaceOrigin) =>
  a.texture === b.texture && a.pitch === b.pitch && a.from === b.from;

/** An outline with corners wherever its look changes. */
export const partedBy = ({ changes }: StockLooks, ring: Ring): Ring =>
  ring.flatMap((p, i) => [p, ...changes(p, ring[(i + 1) % ring.length] ?? p)]);

/** A stretch of a piece of an outline with the edge that lies on it; its ends are shares of the piece. */
interface Stretch<Edge> {
  readonly from: number;
  readonly to: number;
  readonly edge: Edge;
}

/** Finds the edges that lie on a piece of an outline, stretch by stretch along it. */
function stretchesOf<Edge extends StockSide>(edges: readonly Edge[]): (p: Pt, q: Pt) => readonly Stretch<Edge>[] {
  const [left, right] = edges.reduce(
    ([l, h], e) => [Math.min(l, e.z0, e.z1), Math.max(h, e.z0, e.z1)],
    [Infinity, -Infinity],
  );
  const slices: Edge[][] = Array.from({ length: SLICES }, () => []);
  const sliceOf = (z: number) => Math.min(SLICES - 1, Math.max(0, Math.floor(((z - left) * SLICES) / (right - left))));
  const between = (a: number, b: number) =>
    [sliceOf(Math.min(a, b) - BESIDE), sliceOf(Math.max(a, b) + BESIDE)] as const;
  for (const edge of edges) {
    const [first, last] = between(edge.z0, edge.z1);
    for (let s = first; s <= last; s += 1) slices[s]?.push(edge);
  }
  return (p, q) => {
    if (edges.length === 0 || part.apart(p, q) < SAME) return [];
    const [first, last] = between(p.z, q.z),
      near = new Set(slices.slice(first, last + 1).flat());
    return [...near]
      .flatMap((edge) => {
        const share = shareOn(p, q, edge);
        return share ? [{ from: share[0], to: share[1], edge }] : [];
      })
      .sort((a, b) => a.from - b.from);
  };
}

/** The longest of some stretches; null where there is none. */
const longest = <Edge>(all: readonly Stretch<Edge>[]) =>
  all.reduce(
    (best: Stretch<Edge> | null, each) => (best && best.to - best.from >= each.to - each.from ? best : each),
    null,
  );

/** The tone of most of a piece; null if less than half of it has one. */
function toneOf(stretches: readonly Stretch<TonedSide>[]): number | null {
  const total = new Map<number, number>();
  for (const {
    from,
    to,
    edge: { tone },
  } of stretches)
    total.set(tone, (total.get(tone) ?? 0) + to - from);
  const [most] = [...total].sort(([, a], [, b]) => b - a);
  return most && most[1] > 0.5 ? most[0] : null;
}

/**
 * The shares of a piece at which its tone changes, also to none. Stretches no farther apart than `near` are contiguous.
 */
function toneChanges(stretches: readonly Stretch<TonedSide>[], near: number): readonly number[] {
  return stretches.flatMap(({ from, to, edge }, k) => {
    const [before, after] = [stretches[k - 1], stretches[k + 1]];
    const begins = before?.edge.tone !== edge.tone || from - before.to > near,
      ends = !after || after.from - to > near;
    return [...(begins ? [from] : []), ...(ends ? [to] : [])];
  });
}

/**
 * The looks of a stock at a moment: textures by the origin of its surfaces, as in the section, and tones by another
 * quantity.
 */
export function stockLooksOf(
  stock: readonly Ring[],
  surfaces: Surfaces,
  now: PlayPosition,
  tones: readonly TonedSide[] = [],
): StockLooks {
  const { edges } = boundaryIn(stock, surfaces, now, -Infinity, Infinity);
  const makersOn = stretchesOf(edges),
    tonesOn = stretchesOf(tones);
  const there = new Set(edges.map(({ made }) => made.texture));
  return {
    textures: TEXTURE_CODES.flatMap((texture) => (texture && there.has(texture) ? [texture] : [])),
    changes(p, q) {
      const long = part.apart(p, q),
        makers = makersOn(p, q),
        near = CORNER / long;
      const made = makers.flatMap(({ from, edge }, k) => {
        const before = makers[k - 1];
        return before && !looksLike(before.edge.made, edge.made) ? [from] : [];
      });
      const shares = [...made, ...toneChanges(tonesOn(p, q), near)]
        .filter((from) => from > near && 1 - from > near)
        .sort((a, b) => a - b);
      return shares
        .filter((from, k) => from - (shares[k - 1] ?? -1) > near)
        .map((from) => part.pointOn({ kind: "line", from: p, to: q }, from));
    },
    of(p, q) {
      const most = longest(makersOn(p, q));
      if (!most) return null;
      const { made } = most.edge,
        marks = made.texture === "rough" && isAlong(made, q.z - p.z, q.r - p.r, part.apart(p, q));
      return { texture: made.texture, turnAt: marks ? turnsOf(made) : null, tone: toneOf(tonesOn(p, q)) };
    },
  };
}
