import { isRapid, wayOf, type MillMotion } from "./plane-scene.ts";
import { plane } from "../../kernel/plane.ts";

/** The height of the tool over its path: a strip 1 wide and 1 high, upper side first. */
export interface DepthStrip {
  readonly rapid: string;
  readonly feed: string;
  /** Height of the strip's upper and lower edge, mm. */
  readonly high: number;
  readonly low: number;
  /** Where Z0 lies in the strip, 0 … 1; null outside. */
  readonly zero: number | null;
  /** For each motion where it begins, and where the last one ends: parts of the whole path. */
  readonly begins: readonly number[];
}

const n = (v: number) => String(Math.round(v * 1e4) / 1e4 + 0);

/** Z along the whole path. Motions of unknown height are left out. */
export function depthStrip(motions: readonly MillMotion[]): DepthStrip | null {
  const heights = motions.flatMap((m) => [m.from.z, m.to.z]).filter((z) => z !== null);
  if (heights.length === 0) return null;
  const lengths = motions.map((m) => Math.hypot(plane.lengthOf(wayOf(m)), (m.to.z ?? 0) - (m.from.z ?? m.to.z ?? 0)));
  const whole = lengths.reduce((a, b) => a + b, 0) || 1;
  const [high, low] = [heights.reduce((a, b) => Math.max(a, b)), heights.reduce((a, b) => Math.min(a, b))];
  const span = high - low || 1;
  const y = (z: number) => n((high - z) / span);
  const begins: number[] = [];
  const paths = { rapid: "", feed: "" };
  let far = 0;
  motions.forEach((m, i) => {
    begins.push(far / whole);
    const from = far / whole;
    far += lengths[i] ?? 0;
    if (m.from.z === null || m.to.z === null) return;
    paths[isRapid(m) ? "rapid" : "feed"] += `M${n(from)} ${y(m.from.z)}L${n(far / whole)} ${y(m.to.z)}`;
  });
  begins.push(far / whole);
  return { ...paths, high, low, zero: high >= 0 && low <= 0 ? high / span : null, begins };
}

/** Where a moment of the run lies in the strip, 0 … 1. */
export function stripAt({ begins }: DepthStrip, step: number, fraction: number): number {
  const [from, to] = [begins[step], begins[step + 1]];
  if (from === undefined) return 1;
  return to === undefined ? from : from + (to - from) * fraction;
}
