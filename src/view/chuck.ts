import { at, type Ring } from "../kernel/point.ts";
import type { Bounds } from "./camera.ts";

/** A chuck drawn round the far end of the blank. It says where the work is held; it is no part of any check. */
export interface Chuck {
  readonly body: Ring;
  readonly jaw: Ring;
}

const box = (left: number, right: number, low: number, high: number): Ring =>
  [[left, low], [right, low], [right, high], [left, high]].map(([z = 0, r = 0]) => at(z, r));

/**
 * The body stands against the blank's left end, the jaw grips its outside: as far as a sixth of its length, but never
 * where the contour or the tool goes (`busy`).
 */
export function chuckRings(blank: Bounds, busy: Bounds | null): Chuck {
  const length = blank.right - blank.left, outer = blank.high;
  const free = busy ? Math.max(0, busy.left - blank.left) : length;
  const grip = Math.min(length / 6, free * 0.8, 25);
  const deep = Math.min(20, Math.max(6, outer * 0.35));
  return {
    body: box(blank.left - deep, blank.left, 0, outer * 1.2),
    jaw: box(blank.left - deep * 0.35, blank.left + grip, outer, outer * 1.2),
  };
}
