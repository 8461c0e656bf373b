import { METRIC, METRIC_ANGLE } from "../contour/metric-thread.ts";
import { rounded } from "../units.ts";

/**
 * Whitworth profile of ISO 228, ISO 7 and BS 84: depth in pitches, printed for HEIDENHAIN lathes (tag
 * L: MANUALplus 620 p. 572).
 */
export const WHITWORTH = { angle: 55, depth: 0.640327 } as const;
/** Angle of the trapezoidal profile of ISO 2901, and of the round one of DIN 405. */
export const TRAPEZOIDAL_ANGLE = 30;

/** Clearance at crest and root of a trapezoidal thread, mm (ISO 2901): for pitches up to this one. */
const CLEARANCE: readonly (readonly [upTo: number, ac: number])[] = [
  [1.5, 0.15],
  [5, 0.25],
  [12, 0.5],
  [Infinity, 1],
];
export const trapezoidalClearance = (pitch: number): number => CLEARANCE.find(([upTo]) => pitch <= upTo)?.[1] ?? 1;

/** Depth of a profile, mm on the radius, and how it follows from the pitch. */
export interface ProfileDepth {
  readonly depth: number;
  /** In pitches, where the depth is proportional to the pitch. */
  readonly factor?: number;
}

/**
 * Depth of the thread that an insert with this angle cuts at this pitch: ISO and unified at 60°, Whitworth at 55°,
 * trapezoidal at 30°; null for any other angle.
 */
export function depthByAngle(angle: number, pitch: number, inside: boolean): ProfileDepth | null {
  const is = (other: number) => Math.abs(angle - other) < 0.01;
  const by = (factor: number) => ({ depth: rounded(factor * pitch), factor });
  if (is(METRIC_ANGLE)) return by(inside ? METRIC.inside : METRIC.outside);
  if (is(WHITWORTH.angle)) return by(WHITWORTH.depth);
  if (is(TRAPEZOIDAL_ANGLE)) return { depth: rounded(pitch / 2 + trapezoidalClearance(pitch)) };
  return null;
}
