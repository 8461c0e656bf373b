import { areaOf } from "../../kernel/area/area.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { NOTHING } from "../../kernel/tolerance.ts";
import { inStock } from "../contact.ts";
import type { Present } from "../cutting.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { scanCrossings } from "../scan.ts";
import { sweptBy, type Sweep } from "../sweep.ts";

/** Sample lines along the path. */
const LINES = 96;

/** A ring in the coordinates of a path: z along it from its start, r across it. */
function seenAlong(ring: Ring, from: Pt, way: Pt): Ring {
  return ring.map((p) => {
    const d = part.difference(p, from);
    return at(part.dot(d, way), part.cross(way, d));
  });
}

/**
 * The area cut in each of `count` equal parts of a straight path, mm². Each point is cut when the front of the tool
 * reaches it, so points on one line along the path count where the front is at that time. The area under the tool at
 * the start is no chip and does not count.
 */
export function takenAlong(area: readonly Ring[], outline: Ring, from: Pt, to: Pt, count: number): Float64Array {
  const parts = new Float64Array(count);
  const long = part.apart(from, to);
  if (area.length === 0 || long < NOTHING) return parts;
  const way = part.unit(part.difference(to, from));
  const seen = area.map((ring) => seenAlong(ring, from, way));
  const tool = seenAlong(outline, at(0, 0), way);
  const { low, high } = boxAround(seen),
    line = (high - low) / LINES;
  const heights = Array.from({ length: LINES }, (_, i) => low + (i + 0.5) * line);
  const inside = scanCrossings(seen, "z", heights),
    front = scanCrossings([tool], "z", heights);
  const size = long / count;
  let scanned = 0;
  heights.forEach((_, i) => {
    const reach = front[i]?.at(-1),
      crossings = inside[i] ?? [];
    for (let k = 0; k + 1 < crossings.length; k += 2) {
      const [a, b] = [crossings[k] as number, crossings[k + 1] as number];
      scanned += (b - a) * line;
      if (reach === undefined) continue;
      const [begin, end] = [Math.max(0, a - reach), Math.min(long, b - reach)];
      for (let n = Math.floor(begin / size); n < count && n * size < end; n += 1)
        parts[n] = (parts[n] ?? 0) + Math.max(0, Math.min(end, (n + 1) * size) - Math.max(begin, n * size)) * line;
    }
  });
  const exact = scanned > NOTHING ? areaOf(area) / scanned : 0;
  return parts.map((taken) => taken * exact);
}

/** The same for a curved path, from the area removed at the end of each part. */
function takenRound(step: Step, outline: Ring, now: Present, count: number, whole: number): Float64Array {
  let before = 0;
  return Float64Array.from({ length: count }, (_, i) => {
    const gone = i + 1 === count ? whole : areaOf(inStock([sweptBy(outline, step, (i + 1) / count)], now));
    const taken = Math.max(0, gone - before);
    before = Math.max(before, gone);
    return taken;
  });
}

/** The stock cut by a feed in each of `count` equal parts of its path, mm² of the half plane. */
export function takenBy(step: Step, outline: Ring, sweep: Sweep, now: Present, count: number): Float64Array {
  const area = inStock([sweep], now);
  if (area.length === 0) return new Float64Array(count);
  if (step.move.kind === "arc") return takenRound(step, outline, now, count, areaOf(area));
  return takenAlong(area, outline, step.from, step.move.to, count);
}
