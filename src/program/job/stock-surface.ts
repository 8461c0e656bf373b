import type { Site } from "../../cycles/shape-request.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { axial, diameter, toDiameter, toRadius } from "../../kernel/units.ts";

/**
 * A surface of the stock on which an operation starts: a cylinder from its front end to its rear end, or a face from
 * its outer edge to its inner edge.
 */
export interface StockSurface {
  readonly site: Site;
  readonly from: Pt;
  readonly to: Pt;
}

/** Shorter surfaces carry no operation, mm: chamfers and marks of the nose radius. */
const SHORTEST = 1;
/** Differences in radius or Z within one surface, mm. */
const FLAT = 0.005;
/** Largest edge break between a cylinder and the face or the relief beside it, mm. */
const EDGE = 3;
/** Least depth of a relief, mm. */
const RELIEF = 0.2;

interface Edge {
  readonly site: Site;
  readonly a: Pt;
  readonly b: Pt;
}

/** The site that a line of an outline belongs to; the material is on its left. Null for rear faces and slopes. */
function siteOf(a: Pt, b: Pt): Site | null {
  const [dz, dr] = [b.z - a.z, b.r - a.r];
  if (Math.abs(dr) < FLAT && Math.abs(dz) > FLAT) {
    if (dz < 0) return "outside";
    return a.r > FLAT ? "inside" : null;
  }
  return Math.abs(dz) < FLAT && dr > FLAT ? "face" : null;
}

function edgesOf(ring: Ring): Edge[] {
  const edges: Edge[] = [];
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    const site = siteOf(a, b);
    if (site) edges.push({ site, a, b });
  });
  const joined: Edge[] = [];
  for (const edge of edges) {
    const last = joined.at(-1);
    const goesOn = last && last.site === edge.site && Math.hypot(last.b.z - edge.a.z, last.b.r - edge.a.r) < FLAT;
    if (goesOn) joined.splice(-1, 1, { ...last, b: edge.b });
    else joined.push(edge);
  }
  return joined;
}

const lengthOf = ({ from, to }: StockSurface): number => Math.hypot(to.z - from.z, to.r - from.r);

/** The simulation cuts with chords: a size this close to a tenth is that tenth, mm. */
const CHORDAL = 0.006;
const snapped = (n: number): number => {
  const tenth = Math.round(n * 10) / 10;
  return Math.abs(n - tenth) < CHORDAL ? tenth : n;
};
const asTurned = ({ z, r }: Pt): Pt => at(axial(snapped(z)), toRadius(diameter(snapped(toDiameter(r)))));

/** The surfaces of a stock on one site, from the front to the rear. */
export function surfacesOf(stock: readonly Ring[], site: Site): readonly StockSurface[] {
  return stock
    .flatMap(edgesOf)
    .filter((edge) => edge.site === site)
    .map(({ a, b }): StockSurface => {
      const fromA = site === "face" ? a.r > b.r : a.z > b.z;
      return { site, from: asTurned(fromA ? a : b), to: asTurned(fromA ? b : a) };
    })
    .filter((surface) => lengthOf(surface) >= SHORTEST)
    .toSorted((a, b) => b.from.z - a.from.z || b.from.r - a.from.r);
}

/** Front end of the stock in Z. */
export const frontOf = (stock: readonly Ring[]): number => boxOf(stock.flat()).right;

/** Z where the finished part begins: its face at Z0, or the front of a stock that does not reach it. */
export const faceOf = (stock: readonly Ring[]): number => Math.min(0, frontOf(stock));

/** Z where a contour on a cylinder starts: the face, if only an edge break is in front of it. */
export const startOnSurface = ({ from }: StockSurface, stock: readonly Ring[]): number =>
  from.z > faceOf(stock) - EDGE ? faceOf(stock) : from.z;

/** The relief behind a cylinder, from its front end to its rear end in Z; null without one. */
export function reliefBehind(
  surface: StockSurface,
  stock: readonly Ring[],
): { readonly from: number; readonly to: number } | null {
  const into = surface.site === "inside" ? -1 : 1;
  const found = surfacesOf(stock, surface.site).find(
    ({ from }) =>
      from.z <= surface.to.z + FLAT && from.z > surface.to.z - EDGE && (surface.from.r - from.r) * into > RELIEF,
  );
  return found ? { from: surface.to.z, to: found.to.z } : null;
}

/** Whether no material stands in front of the front edge of a cylinder or a bore, where a tool comes in along Z. */
export function hasFreeEdge({ site, from }: StockSurface, stock: readonly Ring[]): boolean {
  const into = site === "inside" ? -1 : 1;
  return stock.flat().every(({ z, r }) => z <= from.z + FLAT || (r - from.r) * into <= RELIEF);
}

/** Diameter of the bore in the front face of a stock, mm; null where it is solid there. */
export function boreOf(stock: readonly Ring[]): number | null {
  const points = stock.flat();
  if (points.length === 0 || points.some(({ z, r }) => r < SAME && z > frontOf(stock) - SAME)) return null;
  const [bore] = surfacesOf(stock, "inside");
  return bore ? toDiameter(bore.from.r) : null;
}

/** The longest surface; the frontmost among equals. */
export const longestOf = (surfaces: readonly StockSurface[]): StockSurface | null =>
  surfaces.reduce<StockSurface | null>((best, s) => (best && lengthOf(best) >= lengthOf(s) ? best : s), null);
