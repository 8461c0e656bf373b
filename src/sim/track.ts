import { at, type Pt, type Ring } from "../kernel/geometry/point.ts";

/** Shorter edges are rounding of an outline, mm. */
const NO_EDGE = 1e-7;

/** A ring without repeated points. */
function withEdges(ring: Ring): Ring {
  const differs = (p: Pt, q: Pt) => Math.abs(p.z - q.z) > NO_EDGE || Math.abs(p.r - q.r) > NO_EDGE;
  return ring.filter((p, i) => differs(p, ring[(i + ring.length - 1) % ring.length] as Pt));
}

/**
 * The area that a convex outline (counter-clockwise, relative to the tip) covers along chords, as one closed curve: out
 * on the right of the path, back on the other side. It may cross itself; by the non-zero rule it is the union of the
 * hulls along all chords (the convolution of path and outline), with two points per chord instead of a whole outline.
 */
export function trackAlong(outline: Ring, way: readonly Pt[]): Ring {
  const around = withEdges(outline);
  const points = way.filter((p, i) => i === 0 || p.z !== way[i - 1]?.z || p.r !== way[i - 1]?.r);
  const count = around.length;
  const curve: Pt[] = [];
  const first = points[0] as Pt;
  const put = (to: Pt, v: number) => {
    const p = around[v] as Pt;
    curve.push(at(to.z + p.z, to.r + p.r));
  };
  if (points.length < 2 || count < 3) return around.map((p) => at(first.z + p.z, first.r + p.r));
  /** Whether the edge that begins at a corner turns left of a direction. */
  const leftOf = (dz: number, dr: number, i: number) => {
    const [p, q] = [around[(i + count) % count] as Pt, around[(i + 1 + count) % count] as Pt];
    return dz * (q.r - p.r) - dr * (q.z - p.z) > 0;
  };
  const last = points.length - 1;
  /** The path there and back, point by point. */
  const visit = (i: number) => points[i <= last ? i : 2 * last - i] as Pt;
  const chord = (i: number) => {
    const [p, q] = [visit(i), visit(i + 1)];
    return [q.z - p.z, q.r - p.r] as const;
  };
  let [dz, dr] = chord(0);
  /** The corner of the outline farthest to the right of the path. */
  let corner = Math.max(
    0,
    around.findIndex((_, i) => leftOf(dz, dr, i) && !leftOf(dz, dr, i - 1)),
  );
  put(first, corner);
  for (let i = 0; i < 2 * last; i += 1) {
    const at = visit(i + 1);
    put(at, corner);
    const [nz, nr] = i + 1 < 2 * last ? chord(i + 1) : chord(0);
    // At both ends the path reverses, to the left.
    const right = i + 1 !== last && i + 1 !== 2 * last && dz * nr - dr * nz < 0;
    const step = right ? -1 : 1;
    for (let k = 0; k < count && (right ? leftOf(nz, nr, corner - 1) : !leftOf(nz, nr, corner)); k += 1) {
      corner = (corner + step + count) % count;
      put(at, corner);
    }
    [dz, dr] = [nz, nr];
  }
  return curve;
}
