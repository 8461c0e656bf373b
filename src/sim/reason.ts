import { crossesChain } from "../kernel/contour/crossing.ts";
import { isBar, noseRadius } from "../kernel/cutter/insert.ts";
import type { Reason } from "../kernel/plan/issue.ts";
import { at, part, type Pt, type Ring } from "../kernel/geometry/point.ts";
import { FAR } from "../kernel/strategy/tip-envelope.ts";
import { boxOf, gapBetween } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import type { Outlines } from "./outlines.ts";
import { placeIn } from "./region.ts";
import type { SimulatedOperation } from "./simulation.ts";
import { sweepAlong } from "./sweep.ts";

/** Distance at which a region touches a swept piece, mm; regions are rounded by less. */
const AGAINST = 0.02;
/** Sample points on the outline of a region. */
const SAMPLES = 200;

interface Sample {
  readonly z: number;
  readonly r: number;
  readonly weight: number;
}

/** Points spread evenly over an outline, each weighted with its share of the length. */
function samplesOf(ring: Ring): Sample[] {
  const out: Sample[] = [];
  const edge = (a: Pt, b: Pt) => hypotenuse(b.z - a.z, b.r - a.r);
  const around = ring.reduce((sum, p, i) => sum + edge(p, ring[(i + 1) % ring.length] as Pt), 0);
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] as Pt;
    const size = edge(p, q);
    const count = Math.max(1, Math.ceil((size / around) * SAMPLES));
    for (let k = 0; k < count; k += 1) {
      const t = (k + 0.5) / count;
      out.push({ z: p.z + (q.z - p.z) * t, r: p.r + (q.r - p.r) * t, weight: size / count });
    }
  });
  return out;
}

/** Whether a point lies on the outline of a convex piece. */
function against(piece: Ring, box: Box, s: Sample): boolean {
  if (s.z < box.left - AGAINST || s.z > box.right + AGAINST || s.r < box.low - AGAINST || s.r > box.high + AGAINST)
    return false;
  let worst = -Infinity;
  let p = piece[piece.length - 1] as Pt;
  for (const q of piece) {
    const size = hypotenuse(q.z - p.z, q.r - p.r);
    if (size > 0) worst = Math.max(worst, ((q.r - p.r) * (s.z - p.z) - (q.z - p.z) * (s.r - p.r)) / size);
    if (worst > AGAINST) return false;
    p = q;
  }
  return worst >= -AGAINST;
}

/** The reason where an operation has no reach: the limit that the plan reports, else the secondary edge. */
function withoutReach(operation: SimulatedOperation): Reason {
  if (isBar(operation.tool)) return "toolWidth";
  return operation.plan.issues.some((i) => i.code === "limitOnWrongSide") ? "limit" : "secondaryEdge";
}

/** Longest corner left by a nose, in nose radii: between elements at 45 degrees it is 2.4. */
const NOSE_CORNER = 3;

/**
 * The reason for residual material between contour elements. Up to the size of a nose corner it is the nose radius.
 * Larger residue is due to the width of a grooving tool, or to the edge that acts nearest to it or cannot follow an
 * element's angle.
 */
function betweenContours(box: Box, operation: SimulatedOperation, acting: Reason | null): Reason {
  const bar = isBar(operation.tool);
  const most = noseRadius(operation.tool) * (bar ? 1 : NOSE_CORNER) + 2 * AGAINST;
  if (box.right - box.left <= most && box.high - box.low <= most) return "insertRadius";
  if (bar) return "toolWidth";
  const edges = operation.plan.issues.flatMap((i) => (i.code === "angleNotFollowed" ? [i.data.edge] : []));
  return acting ?? edges.find((edge) => edge !== "behindContour") ?? "insertRadius";
}

/**
 * Whether the way out of a region is across the contour. Passes follow the contour as it is seen from its open side, so
 * that they do not go there with any tool.
 */
function isBehindContour(ring: Ring, { contour, openSide }: SimulatedOperation["plan"]): boolean {
  const from = placeIn(ring),
    way = part.line(from, at(from.z + openSide.z * FAR, from.r + openSide.r * FAR));
  return crossesChain(way, contour);
}

/**
 * The reason why the deepest path of an operation leaves a region. The longest contact with limited stretches of that
 * path decides. Where all contact is with the contour, the insert leaves it between two elements; without contact the
 * nearest stretch decides.
 */
export function reasonFor(ring: Ring, operation: SimulatedOperation, outlines: Outlines): Reason {
  const reach = operation.plan.reach;
  if (reach.length === 0) return withoutReach(operation);
  if (isBehindContour(ring, operation.plan)) return "behindContour";
  const around = boxOf(ring);
  const samples = samplesOf(ring);
  const length = new Map<Reason, number>();
  let [nearest, nearestReason]: [number, Reason | null] = [Infinity, null];
  let [acting, actingAt]: [Reason | null, number] = [null, Infinity];
  let besideContour = false;
  for (const { path, reason } of reach) {
    for (const swept of sweepAlong(outlines.insert, path)) {
      const box = boxOf(swept);
      const gap = gapBetween(around, box);
      if (gap < nearest) [nearest, nearestReason] = [gap, reason];
      if (reason && gap < actingAt) [acting, actingAt] = [reason, gap];
      if (gap > AGAINST) continue;
      if (!reason) besideContour ||= samples.some((s) => against(swept, box, s));
      else
        for (const s of samples) if (against(swept, box, s)) length.set(reason, (length.get(reason) ?? 0) + s.weight);
    }
  }
  const longest = [...length].sort((a, b) => b[1] - a[1])[0];
  if (longest) return longest[0];
  if (besideContour) return betweenContours(around, operation, acting);
  return (nearest > AGAINST ? nearestReason : acting) ?? betweenContours(around, operation, acting);
}
