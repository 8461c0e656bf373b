import { isRapid, spotOn, wayOf, type MillMotion, type MillSpot } from "../../kernel/plane/mill-motion.ts";
import { partPoint, partSegment, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { boundsOf, grownBounds, joined } from "../bounds.ts";
import type { Bounds } from "../camera.ts";
import { segmentData } from "../path.ts";

/** What a line of the plane stands for. */
export type PlaneRole = "contour" | "rapid" | "feed" | "lead";
export interface PlaneShape {
  readonly role: PlaneRole;
  readonly d: string;
}
export interface PlaneScene {
  readonly shapes: readonly PlaneShape[];
  readonly bounds: Bounds;
}

export const PLANE_ROLES: readonly PlaneRole[] = ["contour", "rapid", "feed", "lead"];

/** The place of the tool at a moment of a run; null in an empty run. */
export function spotAt(motions: readonly MillMotion[], step: number, fraction: number): MillSpot | null {
  const running = motions[step];
  return running ? spotOn(running, fraction) : (motions.at(-1)?.to ?? null);
}

/** Margin, mm per mm of size. */
const AIR = 0.04;
const EMPTY: Bounds = { left: -10, right: 110, low: -10, high: 110 };

const ARC_PARTS = [0.25, 0.5, 0.75];

/** The box of everything that the tool reaches on all motions; null without motions. */
function reachOf(motions: readonly MillMotion[]): Bounds | null {
  let left = Infinity,
    right = -Infinity,
    low = Infinity,
    high = -Infinity;
  const reach = ({ x, y }: MillSpot, radius: number) => {
    left = Math.min(left, x - radius);
    right = Math.max(right, x + radius);
    low = Math.min(low, y - radius);
    high = Math.max(high, y + radius);
  };
  for (const m of motions) {
    reach(m.from, m.radius);
    reach(m.to, m.radius);
    if (m.centre) {
      for (const part of ARC_PARTS) reach(spotOn(m, part), m.radius);
    }
  }
  return left <= right && low <= high ? { left, right, low, high } : null;
}

/** The static part of the picture: contours, and the path split by role. `leads` are the blocks of APPR and DEP. */
export function planeScene(
  motions: readonly MillMotion[],
  contours: readonly (readonly PlaneSegment[])[],
  leads: ReadonlySet<number>,
): PlaneScene {
  const ways: Record<PlaneRole, PlaneSegment[]> = { contour: contours.flat(), rapid: [], feed: [], lead: [] };
  for (const m of motions) ways[isRapid(m) ? "rapid" : leads.has(m.index) ? "lead" : "feed"].push(wayOf(m));
  const box = reachOf(motions);
  const drawn = boundsOf(ways.contour.flatMap((s) => [s.from, s.to]).map(partPoint));
  const all = joined(box, drawn) ?? EMPTY;
  return {
    shapes: PLANE_ROLES.flatMap((role) =>
      ways[role].length > 0 ? [{ role, d: segmentData(ways[role].map(partSegment)) }] : [],
    ),
    bounds: grownBounds(all, AIR * Math.max(all.right - all.left, all.high - all.low)),
  };
}
