import { areaOf } from "../kernel/area/area.ts";
import { difference, intersection } from "../kernel/area/clip.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { withoutSlivers, REAL_AREA } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { boxOf } from "../kernel/area/box.ts";
import { inStock } from "./contact.ts";
import { merged, type Present } from "./cutting.ts";
import type { Outlines } from "./outlines.ts";
import { convexPieceOf } from "./piece.ts";
import { foldedAtAxis, hullAlong, notBehind, piecesAlong, rightOf, sweptBy, waypoints } from "./sweep.ts";

/** Chord error of arcs in the holder check, mm. */
const HOLDER_CHORD = 0.01;
/** Parts of a move in which the order of holder and edge is checked. */
const PARTS = 16;

/** The bounding rectangle of an outline at all points of a path. */
function rectangle(outline: Ring, points: readonly Pt[]): Ring {
  const [own, way] = [boxOf(outline), boxOf(points)];
  const [left, right] = [own.left + way.left, own.right + way.right];
  const [bottom, top] = [own.low + way.low, own.high + way.high];
  return [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ].map(([z, r]) => ({ z, r }) as Pt);
}

/**
 * False when a holder surely touches nothing in a step. Along each chord its sweep meets no stock outside the insert's
 * sweep, and its part that does not follow behind the insert meets no stock. Uses only the edges of the stock.
 */
export function mayTouch(step: Step, { holder, insert }: Outlines, now: Present): boolean {
  const meets = (rings: readonly Ring[]) =>
    rings.flatMap(foldedAtAxis).some((ring) => ring.length > 2 && now.meets(convexPieceOf(ring)));
  const points = waypoints(step, 1, HOLDER_CHORD);
  return holder.some((part) => {
    if (points.length > 2 && !meets([rectangle(part, points)])) return false;
    return points.slice(1).some((to, i) => {
      const from = points[i] as Pt;
      if (!piecesAlong(part, [from, to]).some(now.meets)) return false;
      if (insert.length < 3) return true;
      const covered = hullAlong(part, from, to);
      const track = hullAlong(insert, from, to);
      if (meets(track.map((p, k) => rightOf(covered, p, track[(k + 1) % track.length] as Pt)))) return true;
      return meets(notBehind(part, insert, from, to).map((ahead) => hullAlong(ahead, from, to)));
    });
  });
}

/**
 * The stock touched by the holder that no move up to the same moment has cut away. On a straight path the insert comes
 * first where a point of the holder lies behind it; arcs are checked part by part.
 */
export function holderContact(step: Step, outlines: Outlines, now: Present): Ring[] {
  const sweeps = (parts: readonly Ring[], fraction = 1) =>
    parts.map((part) => sweptBy(part, step, fraction, HOLDER_CHORD));
  const swept = (parts: readonly Ring[], fraction?: number) =>
    merged(sweeps(parts, fraction).flatMap(({ rings }) => rings));
  const touched = inStock(sweeps(outlines.holder), now);
  if (areaOf(touched) < REAL_AREA) return [];
  const left = withoutSlivers(difference(touched, swept([outlines.insert])));
  if (left.length > 0) return left;
  if (step.move.kind === "thread") return [];
  if (step.move.kind !== "arc") {
    const ahead = outlines.holder.flatMap((part) => notBehind(part, outlines.insert, step.from, step.move.to));
    return ahead.length === 0 ? [] : withoutSlivers(intersection(touched, swept(ahead)));
  }
  for (let i = 1; i <= PARTS; i += 1) {
    const reached = intersection(touched, swept(outlines.holder, i / PARTS));
    const hit = reached.length === 0 ? [] : withoutSlivers(difference(reached, swept([outlines.insert], i / PARTS)));
    if (hit.length > 0) return hit;
  }
  return [];
}

export const holderHits = (step: Step, outlines: Outlines, now: Present): Ring[] =>
  step.move.kind === "thread" || mayTouch(step, outlines, now) ? holderContact(step, outlines, now) : [];
