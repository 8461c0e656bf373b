import { isRapid, wayOf, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import { plane } from "../../kernel/plane/plane.ts";

/** The height of the tool over its path: a strip 1 wide and 1 high, upper side first. */
export interface DepthStrip {
  readonly rapid: string;
  readonly feed: string;
  /** Height of the strip's upper and lower edge, mm. */
  readonly high: number;
  readonly low: number;
  /** Where Z0 lies in the strip, 0 … 1; null outside. */
  readonly zero: number | null;
  /** The start of each motion, then the end of the last one: shares of the whole path. */
  readonly begins: readonly number[];
}

const n = (v: number) => String(Math.round(v * 1e4) / 1e4 + 0);

/**
 * With more motions than this, a strip is drawn by columns: finer than the pixels of a picture, each from its highest
 * to its lowest point.
 */
const COLUMNS = 6000;

/** Lines from one point of the strip to the next, as one path per way of moving. */
function drawn(
  motions: readonly MillMotion[],
  begins: readonly number[],
  y: (z: number) => number,
): Pick<DepthStrip, "rapid" | "feed"> {
  const paths = { rapid: "", feed: "" };
  motions.forEach((m, i) => {
    if (m.from.z === null || m.to.z === null) return;
    paths[isRapid(m) ? "rapid" : "feed"] +=
      `M${n(begins[i] ?? 0)} ${n(y(m.from.z))}L${n(begins[i + 1] ?? 1)} ${n(y(m.to.z))}`;
  });
  return paths;
}

/** The same by columns, for motions too many to tell apart. */
function drawnByColumns(
  motions: readonly MillMotion[],
  begins: readonly number[],
  y: (z: number) => number,
): Pick<DepthStrip, "rapid" | "feed"> {
  const made = () => ({
    top: new Float64Array(COLUMNS + 1).fill(Infinity),
    foot: new Float64Array(COLUMNS + 1).fill(-Infinity),
  });
  const columns = { rapid: made(), feed: made() };
  motions.forEach((m, i) => {
    if (m.from.z === null || m.to.z === null) return;
    const { top, foot } = columns[isRapid(m) ? "rapid" : "feed"];
    const [begin, end, from, to] = [begins[i] ?? 0, begins[i + 1] ?? 1, y(m.from.z), y(m.to.z)];
    const [first, last] = [Math.floor(begin * COLUMNS), Math.ceil(end * COLUMNS)];
    for (let column = first; column <= last; column += 1) {
      const part = end > begin ? Math.min(1, Math.max(0, (column / COLUMNS - begin) / (end - begin))) : 0;
      const at = from + (to - from) * part;
      top[column] = Math.min(top[column] ?? at, at);
      foot[column] = Math.max(foot[column] ?? at, at);
    }
  });
  const path = ({ top, foot }: ReturnType<typeof made>) =>
    Array.from(top, (high, column) => {
      const low = foot[column] ?? high;
      return high > low ? "" : `M${n(column / COLUMNS)} ${n(high)}L${n((column + 1) / COLUMNS)} ${n(low)}`;
    }).join("");
  return { rapid: path(columns.rapid), feed: path(columns.feed) };
}

/** Z along the whole path. Motions of unknown height are left out. */
export function depthStrip(motions: readonly MillMotion[]): DepthStrip | null {
  const heights = motions.flatMap((m) => [m.from.z, m.to.z]).filter((z) => z !== null);
  if (heights.length === 0) return null;
  const [high, low] = [heights.reduce((a, b) => Math.max(a, b)), heights.reduce((a, b) => Math.min(a, b))];
  const span = high - low || 1;
  const ends = [0];
  let far = 0;
  for (const m of motions) {
    far += Math.hypot(plane.lengthOf(wayOf(m)), (m.to.z ?? 0) - (m.from.z ?? m.to.z ?? 0));
    ends.push(far);
  }
  const begins = ends.map((end) => end / (far || 1));
  const paths = (motions.length > COLUMNS ? drawnByColumns : drawn)(motions, begins, (z) => (high - z) / span);
  return { ...paths, high, low, zero: high >= 0 && low <= 0 ? high / span : null, begins };
}

/** Where a moment of the run lies in the strip, 0 … 1. */
export function stripAt({ begins }: DepthStrip, step: number, fraction: number): number {
  const [from, to] = [begins[step], begins[step + 1]];
  if (from === undefined) return 1;
  return to === undefined ? from : from + (to - from) * fraction;
}
