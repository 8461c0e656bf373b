import { hypotenuse } from "../kernel/geometry/vectors.ts";
import type { Move } from "../kernel/plan/move.ts";
import { part, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { JOINED } from "../kernel/tolerance.ts";

const { pointOn, polarOf } = part;

/**
 * Path data in part space: x is z, y is r, both mm. The layer that holds the path carries the camera's matrix,
 * so that zooming touches one attribute and no path.
 */

/** Four decimals are a tenth of what a control can keep; no zeros at the end. */
const n = (v: number) => String(Math.round(v * 1e4) / 1e4 + 0);
/** SVG leaves out an arc whose ends meet, so one that is nearly a full circle is drawn as two halves, radians. */
const WHOLE = 6.2;
const at = (p: Pt) => `${n(p.z)} ${n(p.r)}`;

/**
 * Part space counts turns with X up; in the unflipped path a counter-clockwise turn grows the angle, which is SVG's
 * flag 1.
 */
function arc(path: Extract<Segment, { kind: "arc" }>): string {
  const { startRadius, endRadius, sweep } = polarOf(path),
    size = n((startRadius + endRadius) / 2),
    flag = sweep > 0 ? 1 : 0;
  if (Math.abs(sweep) > WHOLE) {
    return `A${size} ${size} 0 0 ${flag} ${at(pointOn(path, 0.5))}A${size} ${size} 0 0 ${flag} ${at(path.to)}`;
  }
  return `A${size} ${size} 0 ${Math.abs(sweep) > Math.PI ? 1 : 0} ${flag} ${at(path.to)}`;
}

const line = (path: Segment) => (path.kind === "arc" ? arc(path) : `L${at(path.to)}`);

/** One motion from the tip's position, without the leading "M". */
export const moveData = (from: Pt, move: Move): string =>
  move.kind === "arc"
    ? arc({ kind: "arc", from, to: move.to, centre: move.centre, turn: move.turn })
    : `L${at(move.to)}`;

/** Where a path begins. */
export const startData = (p: Pt): string => `M${at(p)}`;

/** Segments as one path; a gap between two of them begins a new stretch. */
export function segmentData(segments: Iterable<Segment>): string {
  let d = "",
    last: Pt | null = null;
  for (const s of segments) {
    if (!last || hypotenuse(last.z - s.from.z, last.r - s.from.r) > JOINED) d += startData(s.from);
    d += line(s);
    last = s.to;
  }
  return d;
}

/** Polygons, holes included, as one path for the even-odd rule. */
export const ringData = (rings: Iterable<Ring>): string =>
  [...rings]
    .filter((ring) => ring.length > 2)
    .map((ring) => `M${ring.map(at).join("L")}Z`)
    .join("");

/** Single motions, each from where it starts, as one path. */
export const stretchData = (steps: readonly { readonly from: Pt; readonly move: Move }[]): string =>
  steps.map(({ from, move }) => startData(from) + moveData(from, move)).join("");
