import { part, type Pt, type Ring } from "../../kernel/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { FEED_ALONG } from "../material/lines.ts";
import { boundaryIn, type SurfaceEdge } from "../material/scan.ts";
import type { Maker, Surfaces, Texture } from "../material/surfaces.ts";

/** Textures by the number that stands for them; 0 stands for a surface of which nobody knows. */
export const LOOKS = [null, "raw", "rough", "thread", "finished"] as const satisfies readonly (Texture | null)[];

/** How a piece of a surface looks. */
export interface SideLook {
  readonly texture: Texture;
  /** Which turn of the work left a place, where the feed left marks; null where it left none. */
  readonly turnAt: ((p: Pt) => number) | null;
}

/** Tells how the surfaces of a stock look. */
export interface StockLooks {
  /** Where the look of a straight piece of an outline changes, from its beginning on. */
  readonly changes: (p: Pt, q: Pt) => readonly Pt[];
  /** The look of a straight piece of an outline; null where it is none of the stock: a cut face. */
  readonly of: (p: Pt, q: Pt) => SideLook | null;
  /** What there is to be seen of, in the order of `LOOKS`. */
  readonly textures: readonly Texture[];
}

/** An outline that is shown lies no farther from that of the stock, mm: what was left out of it, and rounding. */
const BESIDE = 0.008;
/** Looks change at corners of the outline when they are no farther from them, mm. */
const CORNER = 0.02;
/** Slices along Z in which pieces are looked for. */
const SLICES = 128;

/** What is said of a place on a surface, as two numbers for each corner. */
export const lookAt = (look: SideLook | null | undefined, p: Pt): readonly [texture: number, turn: number] =>
  look ? [LOOKS.indexOf(look.texture), look.turnAt?.(p) ?? 0] : [0, 0];

const isAlong = ({ way, pitch }: Maker, dz: number, dr: number, long: number) =>
  pitch > 0 && Math.abs(way[0] * dr - way[1] * dz) <= FEED_ALONG * long;

/** A move that runs along a face counts its turns from the axis, another one from where it began. */
const turnsOf = ({ pitch, way, from }: Maker) => (p: Pt): number =>
  Math.abs(way[0]) < FEED_ALONG ? p.r / (pitch * Math.abs(way[1])) : (p.z - from) / (pitch * way[0]);

/** Where on the piece from `p` to `q` an edge of the stock lies, as shares of it; null where it lies beside it or runs back. */
function shareOn(p: Pt, q: Pt, { z0, r0, z1, r1 }: SurfaceEdge): readonly [number, number] | null {
  const [dz, dr] = [q.z - p.z, q.r - p.r], long = Math.hypot(dz, dr);
  if ((z1 - z0) * dz + (r1 - r0) * dr <= 0) return null;
  const away = (z: number, r: number) => Math.abs((z - p.z) * dr - (r - p.r) * dz) / long;
  if (away(z0, r0) > BESIDE || away(z1, r1) > BESIDE) return null;
  const share = (z: number, r: number) => ((z - p.z) * dz + (r - p.r) * dr) / (long * long);
  const [from, to] = [Math.max(0, share(z0, r0)), Math.min(1, share(z1, r1))];
  return to > from ? [from, to] : null;
}

const looksLike = (a: Maker, b: Maker) => a.texture === b.texture && a.pitch === b.pitch && a.from === b.from;

/** An outline with corners wherever its look changes. */
export const partedBy = ({ changes }: StockLooks, ring: Ring): Ring =>
  ring.flatMap((p, i) => [p, ...changes(p, ring[(i + 1) % ring.length] ?? p)]);

/** The looks of a stock at a moment, told by what made it as in the section. */
export function finishOf(stock: readonly Ring[], surfaces: Surfaces, now: PlayPosition): StockLooks {
  const { edges } = boundaryIn(stock, surfaces, now, -Infinity, Infinity);
  const [left, right] = edges.reduce(([l, h], e) => [Math.min(l, e.z0, e.z1), Math.max(h, e.z0, e.z1)], [Infinity, -Infinity]);
  const slices: SurfaceEdge[][] = Array.from({ length: SLICES }, () => []);
  const sliceOf = (z: number) => Math.min(SLICES - 1, Math.max(0, Math.floor(((z - left) * SLICES) / (right - left))));
  const between = (a: number, b: number) => [sliceOf(Math.min(a, b) - BESIDE), sliceOf(Math.max(a, b) + BESIDE)] as const;
  for (const edge of edges) {
    const [first, last] = between(edge.z0, edge.z1);
    for (let s = first; s <= last; s += 1) slices[s]?.push(edge);
  }

  /** What made a piece, stretch by stretch along it. */
  function makersOn(p: Pt, q: Pt) {
    if (part.apart(p, q) < SAME) return [];
    const [first, last] = between(p.z, q.z), near = new Set(slices.slice(first, last + 1).flat());
    return [...near].flatMap((edge) => {
      const share = shareOn(p, q, edge);
      return share ? [{ from: share[0], to: share[1], made: edge.made }] : [];
    }).sort((a, b) => a.from - b.from);
  }

  const there = new Set(edges.map(({ made }) => made.texture));
  return {
    textures: LOOKS.flatMap((texture) => (texture && there.has(texture) ? [texture] : [])),
    changes(p, q) {
      const long = part.apart(p, q), stretches = makersOn(p, q);
      return stretches.flatMap(({ from, made }, k) => {
        const before = stretches[k - 1], isInside = from * long > CORNER && (1 - from) * long > CORNER;
        return before && !looksLike(before.made, made) && isInside ? [part.pointOn({ kind: "line", from: p, to: q }, from)] : [];
      });
    },
    of(p, q) {
      const all = makersOn(p, q),
        most = all.reduce((best: (typeof all)[number] | null, each) => best && best.to - best.from >= each.to - each.from ? best : each,
          null);
      if (!most) return null;
      const { made } = most, marks = made.texture === "rough" && isAlong(made, q.z - p.z, q.r - p.r, part.apart(p, q));
      return { texture: made.texture, turnAt: marks ? turnsOf(made) : null };
    },
  };
}
