import { areaOf, areaOfRing, offset } from "../kernel/clip.ts";
import type { Pt, Ring } from "../kernel/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { boxAround } from "./box.ts";

/** So far beside a corner an area is looked at, mm: the corner itself belongs to both sides. */
const BESIDE = 2e-5;
/** Corners nearer than this are looked at together: between them little changes. */
const NEAR_CORNERS = 0.01;

/** Places beside the corners of an area, each with another one SLIVER farther on: what is thinner than that is none. */
function besides(corners: readonly number[]): (readonly [number, number])[] {
  const sorted = [...corners].sort((a, b) => a - b);
  const out: (readonly [number, number])[] = [];
  let [first, last] = [sorted[0] ?? 0, sorted[0] ?? 0];
  const close = () => {
    for (const a of first === last ? [first] : [first, last]) out.push([a - BESIDE, a - SLIVER], [a + BESIDE, a + SLIVER]);
  };
  for (const a of sorted) {
    if (a - first > NEAR_CORNERS) {
      close();
      first = a;
    }
    last = a;
  }
  close();
  return out;
}

/**
 * The longest way that lies in an area along a direction, mm; gaps thinner than SLIVER do not end it, and what is thinner
 * than that across is passed over. Between two corners of the outlines it changes evenly, so it is longest beside one.
 */
export function deepestAlong(area: readonly Ring[], direction: { readonly z: number; readonly r: number }): number {
  const up = Math.abs(direction.r) >= Math.abs(direction.z);
  const across = (p: Pt): number => (up ? p.z : p.r);
  const along = (p: Pt): number => (up ? p.r : p.z);
  const longestAt = (a: number): number => {
    const crossings: number[] = [];
    for (const ring of area) {
      let p = ring[ring.length - 1] as Pt;
      for (const q of ring) {
        const [from, to] = [across(p), across(q)];
        if (from <= a !== to <= a) crossings.push(along(p) + ((along(q) - along(p)) * (a - from)) / (to - from));
        p = q;
      }
    }
    crossings.sort((x, y) => x - y);
    let [longest, begun] = [0, crossings[0] ?? 0];
    for (let i = 1; i < crossings.length; i += 2) {
      const end = crossings[i] as number;
      longest = Math.max(longest, end - begun);
      const next = crossings[i + 1];
      if (next !== undefined && next - end > SLIVER) begun = next;
    }
    return longest;
  };
  return besides(area.flatMap((ring) => ring.map(across))).reduce((deepest, [near, beyond]) => {
    const here = longestAt(near);
    return here > deepest ? Math.max(deepest, Math.min(here, longestAt(beyond))) : deepest;
  }, 0);
}

const lengthOf = (ring: Ring) =>
  ring.reduce((sum, p, i) => {
    const q = ring[(i + 1) % ring.length] as Pt;
    return sum + Math.hypot(q.z - p.z, q.r - p.r);
  }, 0);

/** How near a thickness is told, as a part of itself, and how often it is tried at most. */
const NEAR = 0.02;
const TRIES = 14;

/**
 * Diameter of the largest circle that fits into an area, mm. A circle of area / outline always fits, and nearly fills a
 * band; from there on larger ones are tried.
 */
export function thicknessOf(area: readonly Ring[]): number {
  const outline = area.reduce((sum, ring) => sum + lengthOf(ring), 0);
  const size = areaOf(area);
  if (!(size > 0 && outline > 0)) return 0;
  const box = boxAround(area);
  const outer = Math.max(...area.map(areaOfRing));
  let low = size / outline;
  let high = Math.min(box.right - box.left, box.top - box.bottom, 2 * Math.sqrt(outer / Math.PI)) / 2;
  let step = 1.04;
  for (let i = 0; i < TRIES && high > low * (1 + NEAR); i += 1) {
    const tried = low * step < high ? low * step : (low + high) / 2;
    if (offset(area, -tried).length > 0) {
      low = tried;
      step = 1 + (step - 1) * 3;
    } else {
      high = tried;
      step = 1 + (step - 1) / 4;
    }
  }
  return low + high;
}
