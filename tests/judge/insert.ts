import type { Tool } from "../../src/kernel/plan/tool.ts";

/*
 * A second model of the insert, from the columns of the tool table alone: a convex polygon about the theoretical tip.
 * It uses nothing from the kernel, so that both cannot have the same fault.
 */

/** A point of the half plane, mm: along the axis and away from it. */
export interface P {
  readonly z: number;
  readonly r: number;
}

/** Points on a quarter of a nose: the error at a radius of 3 mm is a micron, a sixth of what is judged. */
const QUARTER = 32;
/** Length of an edge, and of a recessing bar, whose CUTLENGTH is empty, mm. */
const EDGE = 12;
const BAR = 30;
/** Height of the tooth of a thread insert whose CUTLENGTH is empty, mm. */
const TOOTH = 2.5;

/** Position of the tip relative to the centre of the nose, in radii, by TO. */
const TIP: readonly P[] = [
  { z: 0, r: 0 },
  { z: -1, r: -1 },
  { z: 0, r: -1 },
  { z: 1, r: -1 },
  { z: 1, r: 0 },
  { z: 1, r: 1 },
  {
    z: 0,
    r: 1,
  },
  { z: -1, r: 1 },
  { z: -1, r: 0 },
  { z: 0, r: 0 },
];

const circle = (centre: P, radius: number): P[] =>
  radius === 0
    ? [centre]
    : Array.from({ length: 4 * QUARTER }, (_, i) => {
        const a = (i * Math.PI) / (2 * QUARTER);
        return { z: centre.z + radius * Math.cos(a), r: centre.r + radius * Math.sin(a) };
      });

/** Convex hull of points, counter-clockwise: sorted along z, lower side first. */
export function hull(points: readonly P[]): P[] {
  const sorted = [...points].sort((a, b) => a.z - b.z || a.r - b.r);
  const half = (list: readonly P[]) => {
    const out: P[] = [];
    for (const p of list) {
      for (
        let a = out.at(-2), b = out.at(-1);
        a && b && (b.z - a.z) * (p.r - a.r) - (b.r - a.r) * (p.z - a.z) <= 0;
        a = out.at(-2), b = out.at(-1)
      )
        out.pop();
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

const direction = (degrees: number): P => ({
  z: Math.cos((degrees * Math.PI) / 180),
  r: Math.sin((degrees * Math.PI) / 180),
});
const along = (p: P, d: P, k: number): P => ({ z: p.z + d.z * k, r: p.r + d.r * k });

/**
 * Two edges of length `l` in directions given in degrees, about a nose with its centre in the origin; a parallelogram,
 * or a wedge.
 */
function twoEdges(nose: number, one: number, other: number, l: number, whole: boolean): P[] {
  const half = (((other - one) / 2) * Math.PI) / 180;
  const sharp = along({ z: 0, r: 0 }, direction((one + other) / 2), -nose / Math.sin(half));
  const [a, b] = [along(sharp, direction(one), l), along(sharp, direction(other), l)];
  return [...circle({ z: 0, r: 0 }, nose), a, b, ...(whole ? [along(a, direction(other), l)] : [])];
}

/** ROUGH and FINISH about the centre of the nose. Angles of the table count from −Z, away from the axis. */
function turningInsert(tool: Tool, nose: number): P[] {
  const main = 180 - (tool["T-ANGLE"] ?? 0);
  const shape = twoEdges(nose, main - (tool["P-ANGLE"] ?? 0), main, tool.CUTLENGTH || EDGE, true);
  switch (tool.TO) {
    case 3:
      return shape.map((p) => ({ z: -p.z, r: p.r }));
    case 5:
      return shape.map((p) => ({ z: -p.z, r: -p.r }));
    case 6:
    case 7:
      return shape.map((p) => ({ z: p.z, r: -p.r }));
    case 8:
      return shape.map((p) => ({ z: p.r, r: p.z }));
    case 4:
      return shape.map((p) => ({ z: -p.r, r: p.z }));
    default:
      return shape;
  }
}

/**
 * A recessing bar about its tip, drawn pointing to −X with the tip on its −Z corner, in the middle or on its +Z corner.
 */
function bar(tool: Tool, nose: number): P[] {
  const width = (tool.CUTWIDTH ?? 0) + (tool.DCW ?? 0);
  const long = tool.CUTLENGTH || BAR;
  const left = tool.TO === 1 || tool.TO === 7 ? 0 : tool.TO === 3 || tool.TO === 5 ? -width : -width / 2;
  const right = left + width;
  const shape = [
    ...circle({ z: left + nose, r: nose }, nose),
    ...circle({ z: right - nose, r: nose }, nose),
    { z: right, r: long },
    {
      z: left,
      r: long,
    },
  ];
  switch (tool.TO) {
    case 5:
    case 6:
    case 7:
      return shape.map((p) => ({ z: p.z, r: -p.r }));
    case 8:
      return shape.map((p) => ({ z: p.r, r: p.z }));
    case 4:
      return shape.map((p) => ({ z: -p.r, r: p.z }));
    default:
      return shape;
  }
}

/**
 * Length of a flank from the intersection of both flanks, for a tooth of this height above its tip; `half` in degrees.
 */
function flankOf(height: number, nose: number, half: number): number {
  const lean = (half * Math.PI) / 180;
  return (height - nose + nose / Math.sin(lean)) / Math.cos(lean);
}

/**
 * The area of the insert as a convex polygon about the theoretical tip (including the correction of FUNCTION TURNDATA
 * CORR).
 */
export function insertOf(tool: Tool): P[] {
  const nose = tool.RS + (tool.DRS ?? 0);
  const shift: P = { z: tool.correction?.z ?? 0, r: tool.correction?.r ?? 0 };
  const placed = (points: readonly P[], from: P) =>
    hull(points.map((p) => ({ z: p.z - from.z + shift.z, r: p.r - from.r + shift.r })));
  if (tool.TYPE === "RECESS" || tool.TYPE === "RECTURN") return placed(bar(tool, nose), { z: 0, r: 0 });
  const tip = TIP[tool.TO] ?? { z: 0, r: 0 };
  const offset = { z: tip.z * nose, r: tip.r * nose };
  if (tool.TYPE === "BUTTON") return placed(circle({ z: 0, r: 0 }, nose), offset);
  if (tool.TYPE === "THREAD") {
    const inwards = (Math.atan2(-tip.r, -tip.z) * 180) / Math.PI;
    const half = (tool["P-ANGLE"] ?? 60) / 2;
    return placed(
      twoEdges(nose, inwards - half, inwards + half, flankOf(tool.CUTLENGTH || TOOTH, nose, half), false),
      offset,
    );
  }
  return placed(turningInsert(tool, nose), offset);
}
