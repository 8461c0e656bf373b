import type { NamedPoints } from "../../kernel/plane/approach.ts";
import { isRapid, wayOf, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import { partPoint, partSegment, plane, planePoint, type PlanePoint } from "../../kernel/plane/plane.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { fractionNear, nearestStep, type StepAccess } from "../pick.ts";

const MILLED: StepAccess<MillMotion> = { wayOf: (m) => partSegment(wayOf(m)), cuts: (m) => !isRapid(m) };

/** An APPR or DEP, with the points that can be picked. */
export interface NamedLead {
  readonly index: number;
  readonly points: NamedPoints;
}

/**
 * The approach or departure that has a named point within `reach` mm of a place, and that point; the last one where
 * several have.
 */
function leadAt(
  leads: readonly NamedLead[],
  place: PlanePoint,
  reach: number,
): { readonly index: number; readonly at: PlanePoint } | null {
  let best: { readonly index: number; readonly at: PlanePoint } | null = null;
  let nearest = reach;
  for (const { index, points } of leads)
    for (const at of Object.values(points)) {
      const far = plane.apart(at, place);
      if (far > nearest) continue;
      nearest = far;
      best = { index, at };
    }
  return best;
}

const ofBlock =
  (motions: readonly MillMotion[], index: number) =>
  (step: number): boolean =>
    motions[step]?.index === index;

/**
 * The motion picked at a place, within `reach` mm, and its nearest moment: near a named point a motion of that approach
 * or departure, else the nearest motion. Null if none is near.
 */
export function motionAt(
  motions: readonly MillMotion[],
  leads: readonly NamedLead[],
  place: Pt,
  reach: number,
): PlayPosition | null {
  const lead = leadAt(leads, planePoint(place), reach),
    at = lead ? partPoint(lead.at) : place;
  const own = lead && nearestStep(motions, MILLED, at, reach, ofBlock(motions, lead.index));
  const step = own ?? nearestStep(motions, MILLED, place, reach);
  const motion = step === null ? undefined : motions[step];
  return step === null || !motion ? null : { step, fraction: fractionNear(MILLED.wayOf(motion), at) };
}
