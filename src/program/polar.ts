import type { Pt } from "../kernel/point.ts";
import { axial, inDegrees, radians, radius } from "../kernel/units.ts";
import type { Value, Words } from "../nc/statement.ts";

/**
 * The point of PR and PA round a pole in the Z/X plane: PR is a true length, PA counts from +Z towards +X. What is left
 * out keeps the distance or angle of the point before.
 */
export function polarPoint(
  pole: Pt, before: Pt | null, words: Words, number: (v: Value) => number | null, length: (n: number) => number,
): Pt | null {
  const old = before && { distance: Math.hypot(before.z - pole.z, before.r - pole.r), angle: inDegrees(Math.atan2(before.r - pole.r, before.z - pole.z)) };
  const read = (w: Words["polarAngle"], was: number | undefined, scale: (n: number) => number) => {
    if (!w) return was ?? null;
    const n = number(w.value);
    if (n === null) return null;
    return w.incremental ? (was ?? 0) + scale(n) : scale(n);
  };
  const distance = read(words.polarRadius, old?.distance, length);
  const angle = read(words.polarAngle, old?.angle, (n) => n);
  if (distance === null || angle === null) return null;
  const a = radians(angle);
  return { z: axial(pole.z + distance * Math.cos(a)), r: radius(pole.r + distance * Math.sin(a)) };
}
