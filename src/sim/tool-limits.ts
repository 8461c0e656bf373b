import { boxAround, boxBeyond, boxOf, inBox } from "../kernel/area/box.ts";
import { difference } from "../kernel/area/clip.ts";
import { withoutSlivers } from "../kernel/area/real-area.ts";
import { shankAxis } from "../kernel/cutter/holder.ts";
import { isBar, noseRadius, plungesAxially, tipDirection } from "../kernel/cutter/insert.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { ToolLimit } from "../kernel/plan/issue.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import type { Step } from "../kernel/time/step.ts";
import { SAME } from "../kernel/tolerance.ts";
import { radians } from "../kernel/units.ts";
import type { Present } from "./cutting.ts";
import type { Sweep } from "./sweep.ts";

/** Beyond all material, mm. */
const FAR = 1e5;
/** A wall this near to the side of an axial blade decides by its diameter whether the blade fits, mm. */
const BESIDE = 0.2;

/** A limit that a step exceeds: a diameter, or a depth for CDX, mm, and the material that shows it. */
export interface LimitHit {
  readonly column: ToolLimit;
  readonly value: number;
  readonly limit: number;
  readonly rings: Ring[];
}

type Look = (box: Box) => Ring[];

/** Box along the direction of a tool (`axis`), from one coordinate to another, and across it. */
const boxAlong = (axis: "z" | "r", [a, b]: readonly [number, number], [c, d]: readonly [number, number]): Box =>
  axis === "z"
    ? { left: a, right: b, low: Math.max(0, c), high: d }
    : { left: c, right: d, low: Math.max(0, a), high: b };

const sorted = (a: number, b: number): readonly [number, number] => (a < b ? [a, b] : [b, a]);

/**
 * Depth of a blade in the material on either side of it, within its own width: farther away, an earlier plunge or a
 * lower shoulder leaves room for its holder.
 */
function bladeDepth({ tool, move: { to } }: Step, outline: Ring, stock: Look): LimitHit | null {
  const tip = tipDirection(tool.TO);
  const axis = tip.v === 0 ? "z" : "r";
  const back = axis === "z" ? -Math.sign(tip.u) : -Math.sign(tip.v);
  if (back === 0) return null;
  const own = boxOf(outline);
  const [from, until] = axis === "z" ? [to.r + own.low, to.r + own.high] : [to.z + own.left, to.z + own.right];
  const width = until - from;
  const end = axis === "z" ? to.z : Math.max(0, to.r);
  const limits = [
    ...(tool.CDX === undefined ? [] : [["CDX", tool.CDX, 1] as const]),
    // A blade that parts off a bar reaches from its surface to the axis.
    ...(tool.CUTDIA === undefined || axis === "z" || back < 0 ? [] : [["CUTDIA", tool.CUTDIA / 2, 2] as const]),
  ];
  for (const [column, most, each] of limits) {
    const along = sorted(end + back * (most + SAME), back * FAR);
    const rings = [
      ...stock(boxAlong(axis, along, [from - width, from])),
      ...stock(boxAlong(axis, along, [until, until + width])),
    ];
    if (rings.length === 0) continue;
    const { left, right, low, high } = boxAround(rings);
    const farthest = axis === "z" ? (back > 0 ? right : left) : back > 0 ? high : low;
    return { column, value: each * Math.abs(farthest - end), limit: each * most, rings };
  }
  return null;
}

/**
 * An axial blade is curved for a range of diameters: in a smaller groove it rubs on the outer wall, in a larger one on
 * the inner wall. A wall that is already away does not matter.
 */
function axialDiameter({ tool, move: { to } }: Step, outline: Ring, stock: Look): LimitHit | null {
  const back = -Math.sign(tipDirection(tool.TO).u);
  const own = boxOf(outline);
  const [inner, outer] = [to.r + own.low, to.r + own.high];
  const along = sorted(to.z + back * (noseRadius(tool) + SAME), back * FAR);
  const hit = (column: "DAXN" | "DAXX", limit: number, across: readonly [number, number]): LimitHit | null => {
    const rings = stock(boxAlong("z", along, across));
    return rings.length === 0 ? null : { column, value: 2 * outer, limit, rings };
  };
  const { DAXN, DAXX } = tool;
  return (
    (DAXN !== undefined && 2 * outer < DAXN - SAME ? hit("DAXN", DAXN, [outer, outer + BESIDE]) : null) ??
    (DAXX !== undefined && 2 * outer > DAXX + SAME ? hit("DAXX", DAXX, [inner - BESIDE, inner]) : null)
  );
}

/**
 * How far behind its tip, mm, a bar with its tip at a radius needs the bore of its row: in front of that are its nose, and
 * with a leaning main edge a cone of the bottom.
 */
export function needsBoreBehind(tool: Tool, r: number): number {
  const lean = Math.max(0, -1 / Math.tan(radians(tool["T-ANGLE"] ?? 180))) * Math.min(r, tool.DMIN ?? 0);
  return 2 * noseRadius(tool) + lean;
}

/** A bar in a bore narrower than it needs, anywhere between its tip and the mouth of the bore. */
function narrowBore({ tool, move: { to } }: Step, outline: Ring, stock: Look): LimitHit | null {
  const { DMIN, TO, holder } = tool;
  const tip = tipDirection(TO);
  if (DMIN === undefined || tip.v <= 0 || shankAxis(TO, holder?.axis) !== "Z") return null;
  const own = boxOf(outline);
  const length = tip.u > 0 ? -own.left : own.right;
  const behind = SAME + (tip.u === 0 ? length : Math.min(length, needsBoreBehind(tool, to.r)));
  const along = tip.u > 0 ? sorted(to.z - behind, -FAR) : sorted(to.z + behind, FAR);
  if (stock(boxAlong("z", along, [to.r + SAME, FAR])).length === 0) return null;
  const rings = stock(boxAlong("z", along, [to.r - DMIN, DMIN / 2 - SAME]));
  return rings.length === 0 ? null : { column: "DMIN", value: 2 * boxAround(rings).low, limit: DMIN, rings };
}

const hasLimits = (t: Tool) =>
  t.DMIN !== undefined ||
  (isBar(t) && (t.CDX !== undefined || t.CUTDIA !== undefined || t.DAXN !== undefined || t.DAXX !== undefined));

/** The limit of its tool that a step exceeds at its end, once its own cut is away; null for none. */
export function limitHit(step: Step, sweep: Sweep, outline: Ring, now: Present): LimitHit | null {
  const { tool, move } = step;
  if (!hasLimits(tool) || move.kind === "thread" || !Number.isFinite(move.to.z + move.to.r)) return null;
  const stock: Look = (box) => {
    const there = inBox(now.base, box);
    if (there.length === 0) return [];
    const beyond = boxBeyond(there);
    return withoutSlivers(difference(there, [...inBox(now.gone, beyond), ...inBox(sweep.rings, beyond)]));
  };
  const blade = isBar(tool) && (tool.CDX !== undefined || tool.CUTDIA !== undefined);
  return (
    (blade ? bladeDepth(step, outline, stock) : null) ??
    (plungesAxially(tool) && move.kind !== "rapid" ? axialDiameter(step, outline, stock) : null) ??
    narrowBore(step, outline, stock)
  );
}
