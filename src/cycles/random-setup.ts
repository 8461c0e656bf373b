import { contourFrom, type ContourElement } from "../kernel/contour/contour.ts";
import { at, part, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import type { TipOrientation } from "../kernel/plan/tool.ts";
import { inDegrees, radians, radius, rounded, toDiameter } from "../kernel/units.ts";

/** Random numbers for set-ups that nobody thought of. The caller provides the generator. */
export interface Draw {
  /** One of these, with equal probability. */
  one<T>(...of: readonly T[]): T;
  /** A whole number. */
  whole(min: number, max: number): number;
}

/** A random set-up of a cycle: its values without Q215, and tool, start and blank to match. mm; Q values as typed. */
export interface RandomSetup {
  readonly values: Readonly<Record<string, number>>;
  /** For a free-contour cycle. */
  readonly contour: readonly Segment[] | null;
  /** A shipped tool, the orientation of its tip, and other changed columns. */
  readonly tool: {
    readonly T: number;
    readonly TO: TipOrientation;
    readonly RS?: number;
    readonly CUTWIDTH?: number;
    readonly CUTLENGTH?: number;
  };
  /** The tip at the call in a valid set-up. */
  readonly start: Pt;
  readonly blank: Ring;
}

/** Draws a set-up; null when the draw makes no contour. */
export type Setups = (draw: Draw) => RandomSetup | null;

/** A length on the grid of a control. */
export const mm = (draw: Draw, min: number, max: number) =>
  draw.whole(Math.round(min * 1000), Math.round(max * 1000)) / 1000;
/** An angle from 0. */
const angle = (draw: Draw, max: number) => draw.whole(0, max * 10_000) / 10_000;
/** A radius from a diameter on that grid. */
export const half = (draw: Draw, min: number, max: number) => radius(draw.whole(min * 2000, max * 2000) / 2000);
/** Usually the first, sometimes the other. */
export const mostly = <T>(draw: Draw, usual: T, other: T) => draw.one(usual, usual, usual, usual, usual, other, other);

/** A box from two opposite corners. */
export function box(z0: number, z1: number, r0: number, r1: number): Ring {
  const [left, right, low, high] = [Math.min(z0, z1), Math.max(z0, z1), Math.min(r0, r1), Math.max(r0, r1)];
  return [at(left, low), at(right, low), at(right, high), at(left, high)];
}

/** Values of every roughing cycle. */
const common = (draw: Draw) => ({
  Q460: mm(draw, 0.5, 4),
  Q478: 0.3,
  Q483: draw.one(0, mm(draw, 0, 1.5)),
  Q484: draw.one(0, mm(draw, 0, 0.7)),
  Q505: 0.1,
  Q463: mm(draw, 0.3, 5),
});
/** Start element, corner and end element of the cycles with their own contour. */
const elements = (draw: Draw) => ({
  Q501: draw.one(0, 1, 2),
  Q502: mm(draw, 0, 2),
  Q500: draw.one(0, mm(draw, 0, 3)),
  Q503: draw.one(0, 1, 2),
  Q504: mm(draw, 0, 2),
});

/** Orientation of a tip that cuts outside or inside, from +Z or −Z. */
const tipOf = (out: 1 | -1, along: 1 | -1): TipOrientation => (out > 0 ? (along > 0 ? 1 : 3) : along > 0 ? 7 : 5);
/** Orientation of a button tool that cuts along the axis, or across it. */
const squareTip = (out: 1 | -1, along: 1 | -1, transverse: boolean): TipOrientation =>
  transverse ? (along > 0 ? 8 : 4) : out > 0 ? 2 : 6;

/** An end on the axis, or beyond it as setters program it. */
const atAxis = (draw: Draw) => radius(draw.one(0, 0, -0.8, -0.2));
/** A wall angle, sometimes in whole degrees as flanks of inserts are. */
const wallAngle = (draw: Draw, max: number) => draw.one(0, angle(draw, max), draw.whole(0, max));

/**
 * Less than the resolution of a control, mm: it makes a depth just more or just less than a whole number of infeeds.
 */
const HAIR = 1e-4;

/** Sometimes an infeed that divides a depth exactly, or just not. */
function infeedInto(draw: Draw, depth: number, usual: number): number {
  const exact = (depth + draw.one(0, HAIR, -HAIR)) / draw.whole(1, 7);
  return mostly(draw, usual, exact > 0.3 ? exact : usual);
}

/** Set-ups of the shoulder cycles: outside and inside, towards −Z and +Z, sometimes up to the axis and past it. */
const boxSetups =
  (transverse: boolean): Setups =>
  (draw) => {
    const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
    const [r, z1, T] = [
      half(draw, 20, 50),
      mm(draw, -5, 5),
      transverse ? draw.one(15, 1, 2, 11) : draw.one(1, 2, 4, 11),
    ];
    const z2 = rounded(z1 - along * (transverse ? mm(draw, 1, 25) : mm(draw, 3, 70)));
    const deep = transverse ? mm(draw, 2, 19) : mm(draw, 1, 15);
    const [over, before] = [draw.one(0, mm(draw, -2, 6)), mm(draw, 0, 8)];
    const axis = mostly(draw, null, atAxis(draw));
    // A face that is cut away from the axis begins on it.
    const r1 = axis !== null && transverse && out < 0 ? axis : r;
    const end = axis !== null && out > 0 ? axis : radius(r - out * deep);
    const usual = common(draw);
    const depth = transverse
      ? Math.abs(z2 - z1) + Math.max(0, over)
      : Math.abs(r - Math.max(0, end)) + Math.max(0, over);
    return {
      values: {
        ...usual,
        ...elements(draw),
        Q463: infeedInto(draw, depth, usual.Q463),
        Q495: wallAngle(draw, 20),
        Q496: wallAngle(draw, 30),
        // An edge on the axis cannot be broken, and a face to the axis is usually square.
        ...(axis !== null && {
          Q501: 0,
          Q503: 0,
          Q495: mostly(draw, 0, wallAngle(draw, 20)),
          Q496: mostly(draw, 0, wallAngle(draw, 30)),
        }),
        Q506: draw.one(0, 1, 2),
        Q491: toDiameter(r1),
        Q492: z1,
        Q493: rounded(toDiameter(end)),
        Q494: z2,
      },
      contour: null,
      tool: { T, TO: T === 11 ? squareTip(out, along, transverse) : tipOf(out, along) },
      start: transverse
        ? at(z1 + along * over, Math.max(0.5, r1 + out * before))
        : at(z1 + along * before, Math.max(0.5, r1 + out * over)),
      blank: box(z1, z2 - along * 30, r1, out > 0 ? 0 : r1 + 60),
    };
  };
/** Along the axis, and across it. */
export const shoulderSetups = boxSetups(false);
export const faceSetups = boxSetups(true);

/** Set-ups of the cycles that plunge behind a flank: outside and inside, towards −Z and +Z, with an edge in front. */
export const plungeSetups =
  (transverse: boolean): Setups =>
  (draw) => {
    const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
    const [r1, z1, T] = [
      half(draw, 24, 50),
      mm(draw, -15, 5),
      transverse ? draw.one(15, 15, 4, 11) : draw.one(2, 3, 4, 11),
    ];
    const [wide, deep] = transverse ? [mm(draw, 6, 20), mm(draw, 1, 12)] : [mm(draw, 10, 60), mm(draw, 1, 12)];
    const z2 = rounded(z1 - along * (transverse ? deep : wide));
    // The flank takes at most three quarters of the width.
    const steepest = Math.min(85, Math.floor(inDegrees(Math.atan2(0.75 * wide, deep))));
    const [over, before, room] = [draw.one(0, mm(draw, 0, 6)), mm(draw, 0, 8), mm(draw, 1, 9)];
    const usual = common(draw);
    return {
      values: {
        ...usual,
        ...elements(draw),
        Q463: infeedInto(draw, deep + over, usual.Q463),
        Q495: draw.one(steepest, wallAngle(draw, steepest)),
        Q496: draw.one(0, angle(draw, 10)),
        Q506: draw.one(0, 1, 2),
        Q491: toDiameter(r1),
        Q492: z1,
        Q493: rounded(toDiameter(radius(r1 - out * (transverse ? wide : deep)))),
        Q494: z2,
      },
      contour: null,
      tool: { T, TO: T === 11 ? squareTip(out, along, transverse) : tipOf(out, along) },
      start: transverse
        ? at(z1 + along * over, Math.max(0.5, r1 + out * before))
        : at(z1 + along * before, Math.max(0.5, r1 + out * over)),
      blank: transverse
        ? box(z1, z2 - along * 30, r1 + out * room, out > 0 ? 0 : r1 + 60)
        : box(z1 + along * room, z2 - along * 30, r1, out > 0 ? 0 : r1 + 60),
    };
  };

/** A set-up without some of its values. */
const without =
  (setups: Setups, unasked: readonly string[]): Setups =>
  (draw) => {
    const drawn = setups(draw);
    return (
      drawn && {
        ...drawn,
        values: Object.fromEntries(Object.entries(drawn.values).filter(([q]) => !unasked.includes(q))),
      }
    );
  };

/** Set-ups of a cycle without edges, corner radii or an angle at its end. */
const CORNERS = ["Q496", "Q500", "Q501", "Q502", "Q503", "Q504"];
export const withoutCornerElements = (setups: Setups): Setups => without(setups, CORNERS);

/** Set-ups of a simple cycle: it has only the second corner of the box. */
export const simpleSetups = (setups: Setups): Setups => without(setups, ["Q491", "Q492", "Q495", ...CORNERS]);

/**
 * Two to six segments in the cutting direction, rising and falling, with corners between them, sometimes an arc or an
 * end on the axis. `place`: the point at a distance `on` along the contour and a height `up`.
 */
function drawnContour(draw: Draw, place: (on: number, up: number) => Pt, toAxis: boolean): ContourElement[] {
  const [first, count] = [place(0, 0), draw.whole(2, 6)];
  const made: ContourElement[] = [{ kind: "line", to: first }];
  let [here, on, up] = [first, 0, 0];
  for (let i = 1; i <= count; i += 1) {
    const step = draw.one(mm(draw, 0.5, 6), mm(draw, 0.5, 6), 0);
    const usual = mm(draw, -6, 6);
    // Whole degrees, as flanks of inserts have them.
    const degrees = mostly(draw, null, draw.whole(-60, 60));
    const rise = degrees === null || step === 0 ? usual : rounded(step * Math.tan(radians(degrees)));
    [on, up] = [rounded(on + step), rounded(up + (step === 0 ? Math.abs(rise) + 0.5 : rise))];
    const to = place(on, up);
    const chord = part.apart(here, to);
    const bulge = mostly(draw, 0, mm(draw, 0.6, 3));
    if (bulge > 0 && chord > 0.5)
      made.push({ kind: "radius", to, radius: rounded(chord * bulge), turn: draw.one("cw", "ccw") });
    else made.push({ kind: "line", to });
    here = to;
    const corner = draw.one("none", "round", "chamfer");
    if (corner !== "none" && i < count) made.push({ kind: corner, size: mm(draw, 0.2, 1.5) });
  }
  const last = mostly(draw, null, draw.one(null, 0, -0.8, -0.4));
  // Square to the axis, or as a cone or a dish.
  if (last !== null && toAxis)
    made.push({ kind: "line", to: at(rounded(here.z + mostly(draw, 0, mm(draw, -4, 4))), last) });
  return made;
}

/** Set-up of a free contour: its start, its direction, its open side, and the blank. */
interface Free {
  readonly place: (on: number, up: number) => Pt;
  readonly toAxis: boolean;
  readonly tool: { readonly T: number; readonly TO: TipOrientation };
  /** Start point and blank that enclose the points of the contour. */
  readonly round: (points: readonly Pt[]) => { readonly start: Pt; readonly blank: Ring };
}

/** Across the axis towards it or away from it, open towards +Z. */
function freeAcross(draw: Draw): Free {
  const out = draw.one<1 | -1>(1, -1);
  const r = mm(draw, 26, 45);
  const first = at(mm(draw, -25, -5), out > 0 ? r : r - 10);
  const T = draw.one(15, 1, 2, 11);
  const [over, before] = [mm(draw, 0, 3), out * draw.one(0, mm(draw, 0, 3))];
  return {
    place: (on, up) => at(rounded(first.z + up), Math.max(0.5, rounded(first.r - out * on))),
    toAxis: out > 0,
    tool: { T, TO: T === 11 ? 8 : tipOf(out, 1) },
    round(points) {
      const top = Math.max(...points.map((p) => p.z));
      return {
        start: at(top + over, Math.max(0.5, first.r + before)),
        blank: box(top, -90, first.r, out > 0 ? 0 : first.r + 80),
      };
    },
  };
}

/** Along the axis towards −Z or +Z, a shaft or a bore. */
function freeAlong(draw: Draw): Free {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  // Sometimes the face in front belongs to the contour, from the axis.
  const face = out > 0 ? mostly(draw, null, draw.one(0, 0, -0.8)) : null;
  const first = at(mm(draw, -5, 5), mm(draw, 20, 45));
  const T = draw.one(2, 1, 3, 11);
  const [over, before] = [mm(draw, 0, 3), draw.one(0, mm(draw, 0, 3))];
  return {
    place: (on, up) =>
      face !== null && on === 0 && up === 0
        ? at(first.z, face)
        : at(rounded(first.z - along * on), Math.max(0.5, rounded(first.r + out * up))),
    toAxis: false,
    tool: { T, TO: T === 11 ? squareTip(out, along, false) : tipOf(out, along) },
    round(points) {
      const rs = points.map((p) => p.r);
      const top = out > 0 ? Math.max(...rs) : Math.min(...rs);
      return {
        start: at(first.z + along * before, Math.max(0.5, top + out * over)),
        blank: box(first.z, first.z - along * 70, top, out > 0 ? 0 : top + 80),
      };
    },
  };
}

/** Machining limits: usually through the contour, one or both of them; else anywhere. */
function limits(draw: Draw, points: readonly Pt[]): Readonly<Record<string, number>> {
  const through = (all: readonly number[]) => mm(draw, Math.min(...all), Math.max(...all));
  const [x, z] = [toDiameter(radius(through(points.map((p) => p.r)))), through(points.map((p) => p.z))];
  const [Q480, Q482] = draw.one([x, z], [x, -99], [0, z], [mm(draw, 0, 100), mm(draw, -40, 10)]);
  return { Q479: draw.one(0, 0, 1), Q480, Q482 };
}

/**
 * Set-ups of free contours that are cut by levels, in both directions, with limits on every side. A contour that
 * crosses itself is refused before any cycle gets it.
 */
export const contourSetups =
  (transverse: boolean): Setups =>
  (draw) => {
    const free = transverse ? freeAcross(draw) : freeAlong(draw);
    const built = contourFrom(drawnContour(draw, free.place, free.toAxis));
    if (built.issues.some((i) => i.severity === "error")) return null;
    const points = built.segments.flatMap((s) => [s.from, s.to]);
    return {
      values: {
        ...common(draw),
        Q499: mostly(draw, 0, draw.one(1, 2)),
        Q487: draw.one(0, 1),
        Q488: draw.one(0, 0.1),
        Q506: draw.one(0, 1, 2),
        ...limits(draw, points),
      },
      contour: built.segments,
      tool: free.tool,
      ...free.round(points),
    };
  };

/** The generators that other families use. */
export const dice = { mm, angle, half, mostly, box, common, elements, contour: drawnContour, limits };
