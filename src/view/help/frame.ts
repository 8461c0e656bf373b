import type { Pt, Segment } from "../../kernel/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import type { Group } from "../../cycles/define.ts";
import type { Params } from "../../cycles/params.ts";

/** Part space seen along the cut: `u` runs with the cutting feed, `v` towards the side the tool comes from, mm. */
export interface HelpFrame {
  /** Which coordinate the infeed changes: r for cutting along the axis, z for cutting across it. */
  readonly infeed: "r" | "z";
  /** Sign of the cutting feed on the other coordinate. */
  readonly feed: 1 | -1;
  /** Sign of "away from the material" on the infeed's coordinate. */
  readonly open: 1 | -1;
  /** True where the material stands on both sides of the cut. */
  readonly recess: boolean;
}

const signOf = (n: number, zero: 1 | -1): 1 | -1 => (n > 1e-9 ? 1 : n < -1e-9 ? -1 : zero);

/** Whether the infeed goes along the axis: read from the parameters, where an axial depth says so. */
const axialInfeed = (params: Params) => Object.values(params).some((p) => p.kind === "axialDepth");

/** The frame of a contour in machining direction. A free contour is open towards +Z or away from the axis, whichever way it runs. */
export function helpFrameOf(group: Group, params: Params, contour: readonly Segment[]): HelpFrame {
  const start = contour[0]?.from, end = contour.at(-1)?.to;
  if (!start || !end) return { infeed: "r", feed: -1, open: 1, recess: false };
  const infeed = axialInfeed(params) ? "z" : "r";
  const across = infeed === "z" ? end.r - start.r : end.z - start.z;
  const rise = infeed === "z" ? end.z - start.z : end.r - start.r;
  if (group === "contour") return { infeed, feed: signOf(across, -1), open: 1, recess: false };
  if (group === "shoulder") return { infeed, feed: signOf(across, -1), open: signOf(rise, 1), recess: false };
  const mouth = infeed === "z" ? start.z : start.r;
  const deepest = contour.map((s) => (infeed === "z" ? s.to.z : s.to.r) - mouth).reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
  return { infeed, feed: signOf(across, -1), open: signOf(-deepest, 1), recess: true };
}

/** Coordinate along the cutting feed. */
export const along = (f: HelpFrame, p: Pt): number => f.feed * (f.infeed === "r" ? p.z : p.r);
/** Coordinate towards the open side. */
export const outward = (f: HelpFrame, p: Pt): number => f.open * (f.infeed === "r" ? p.r : p.z);
/** The point with these two coordinates. */
export function pointAt(f: HelpFrame, u: number, v: number): Pt {
  const [a, b] = [f.feed * u, f.open * v];
  return f.infeed === "r" ? { z: axial(a), r: radius(b) } : { z: axial(b), r: radius(a) };
}
