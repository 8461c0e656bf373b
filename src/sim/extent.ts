import { areaOf, areaOfRing } from "../kernel/area/area.ts";
import { offset } from "../kernel/area/clip.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { boxAround } from "../kernel/area/box.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { scanCrossings } from "./scan.ts";

/** Distance of a sample from a corner, mm: the corner itself belongs to both sides. */
const BESIDE = 2e-5;
/** Corners nearer than this are sampled together, since little changes between them, mm. */
const NEAR_CORNERS = 0.01;

/**
 * Sample places beside the corners of an area, each with a second one SLIVER farther on: anything thinner is ignored.
 */
function placesAtCorners(corners: readonly number[]): (readonly [number, number])[] {
  const sorted = [...corners].sort((a, b) => a - b);
  const out: (readonly [number, number])[] = [];
  let [first, last] = [sorted[0] ?? 0, sorted[0] ?? 0];
  const close = () => {
    for (const a of first === last ? [first] : [first, last])
      out.push([a - BESIDE, a - SLIVER], [a + BESIDE, a + SLIVER]);
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
 * The longest stretch inside an area along a direction, mm. Gaps thinner than SLIVER do not end it, and parts thinner
 * than that across are ignored. It changes evenly between two corners, so the maximum is beside a corner.
 */
export function deepestAlong(area: readonly Ring[], direction: { readonly z: number; readonly r: number }): number {
  const up = Math.abs(direction.r) >= Math.abs(direction.z);
  const [along, across] = up ? (["r", "z"] as const) : (["z", "r"] as const);
  const longest = (places: readonly number[]): number => {
    let [most, begun] = [0, places[0] ?? 0];
    for (let i = 1; i < places.length; i += 2) {
      const end = places[i] as number;
      most = Math.max(most, end - begun);
      const next = places[i + 1];
      if (next !== undefined && next - end > SLIVER) begun = next;
    }
    return most;
  };
  const pairs = placesAtCorners(area.flatMap((ring) => ring.map((p) => p[across]))).sort(([a], [b]) => a - b);
  const depths = scanCrossings(
    area,
    along,
    pairs.map(([near]) => near),
  ).map(longest);
  const order = depths.map((_, i) => i).sort((i, k) => (depths[k] ?? 0) - (depths[i] ?? 0));
  let deepest = 0;
  for (const i of order) {
    const [here, beyond] = [depths[i] ?? 0, pairs[i]?.[1] ?? 0];
    if (here <= deepest) break;
    deepest = Math.max(deepest, Math.min(here, longest(scanCrossings(area, along, [beyond])[0] ?? [])));
  }
  return deepest;
}

/** Spacing of the test lines, as a share of the diameter. */
const GRATING = 0.25;
/** With more lines the test costs more than it saves. */
const MOST_LINES = 4000;

/**
 * False when surely no circle of a diameter (mm) fits into an area. A circle that fits meets three lines in a row, the
 * middle one within half a spacing of its centre. It crosses each of them over at least the shortest chord that this
 * allows.
 */
export function hasRoomFor(area: readonly Ring[], diameter: number): boolean {
  const box = boxAround(area);
  const space = GRATING * diameter;
  if (!(box.right - box.left >= diameter && box.high - box.low >= diameter)) return false;
  const chord = diameter * Math.sqrt(1 - (3 * GRATING) ** 2) - 2 * BESIDE;
  const count = Math.ceil((box.right - box.left) / space) + 1;
  if (!(count < MOST_LINES)) return true;
  const lines = scanCrossings(
    area,
    "r",
    Array.from({ length: count }, (_, i) => box.left + i * space),
  );
  const common = (a: readonly number[], b: readonly number[]): number[] => {
    const out: number[] = [];
    for (let i = 0; i + 1 < a.length; i += 2)
      for (let k = 0; k + 1 < b.length; k += 2) {
        const [from, to] = [Math.max(a[i] as number, b[k] as number), Math.min(a[i + 1] as number, b[k + 1] as number)];
        if (to - from >= chord) out.push(from, to);
      }
    return out;
  };
  return lines.some((line, i) => common(common(lines[i - 1] ?? [], line), lines[i + 1] ?? []).length > 0);
}

const lengthOf = (ring: Ring) =>
  ring.reduce((sum, p, i) => {
    const q = ring[(i + 1) % ring.length] as Pt;
    return sum + hypotenuse(q.z - p.z, q.r - p.r);
  }, 0);

/** Relative tolerance of a thickness, and the most tries. */
const NEAR = 0.02;
const TRIES = 14;

/**
 * Diameter of the largest circle that fits into an area, mm. A circle of area / outline always fits, and nearly fills a
 * band; the search goes up from there.
 */
export function thicknessOf(area: readonly Ring[]): number {
  const outline = area.reduce((sum, ring) => sum + lengthOf(ring), 0);
  const size = areaOf(area);
  if (!(size > 0 && outline > 0)) return 0;
  const box = boxAround(area);
  const outer = Math.max(...area.map(areaOfRing));
  let low = size / outline;
  let high = Math.min(box.right - box.left, box.high - box.low, 2 * Math.sqrt(outer / Math.PI)) / 2;
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
