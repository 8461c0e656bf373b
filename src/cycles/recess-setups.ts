import { contourFrom, type ContourElement } from "../kernel/contour/contour.ts";
import { at, type Pt } from "../kernel/geometry/point.ts";
import { radius, rounded, toDiameter } from "../kernel/units.ts";
import { dice, type Draw, type RandomSetup, type Setups } from "./random-setup.ts";

const { angle, box, common, elements, half, mm, mostly } = dice;

/** Less than the resolution of a control, mm: a recess may be this much narrower than its tool. */
const HAIR = 1e-4;
/**
 * Usually the usual width; sometimes that of the blade between the oversizes, or just more or less. `kept`: oversize of
 * both walls together.
 */
const widthOf = (draw: Draw, usual: number, blade: number, kept: number) =>
  mostly(draw, usual, blade + kept + draw.one(0, HAIR, -HAIR, 0.05, -0.05, 0.3));
/** Sometimes an infeed that divides a depth exactly, or just not. */
const infeedInto = (draw: Draw, usual: number, depth: number) =>
  mostly(draw, usual, Math.max(0.3, (depth + draw.one(0, HAIR, -HAIR)) / draw.whole(1, 5)));

/** A set-up of a recess, with its first corner. */
interface RecessSetup extends RandomSetup {
  readonly corner: Pt;
}

/** Values of every recess-turning cycle. */
const turnedValues = (draw: Draw) => ({
  ...common(draw),
  Q507: draw.one(0, 1),
  Q508: draw.one(0, mm(draw, 0, 1)),
  Q509: mostly(draw, 0, mm(draw, -0.3, 0.3)),
  Q488: draw.one(0, 0.05),
});
/** Walls and corners of the recesses that have them. */
const walls = (draw: Draw) => ({
  ...elements(draw),
  Q495: draw.one(0, angle(draw, 10)),
  Q496: draw.one(0, angle(draw, 10)),
});

const axialTool = (draw: Draw, along: 1 | -1) => ({
  T: 8,
  TO: along > 0 ? (8 as const) : (4 as const),
  CUTWIDTH: draw.one(2, 3, 4),
  RS: draw.one(0, 0.2, 0.4),
});
/** A bar that points at the axis or away from it, with its tip in the middle of the edge or at either corner. */
const radialTool = (draw: Draw, out: 1 | -1) => ({
  T: out > 0 ? 9 : 14,
  TO:
    out > 0
      ? mostly(draw, 2 as const, draw.one(1 as const, 3 as const))
      : mostly(draw, 6 as const, draw.one(5 as const, 7 as const)),
  CUTWIDTH: draw.one(2, 3, 4),
  RS: draw.one(0, 0.2, 0.4),
});

/** Set-ups of the axial recess-turning cycles: outer and inner wall first, from +Z and from −Z. */
export const axialRecesses = (draw: Draw): RecessSetup => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r1, z1] = [half(draw, 20, 50), mm(draw, -20, 5)];
  const [tool, values, deep] = [axialTool(draw, along), turnedValues(draw), mm(draw, 2, 28)];
  return {
    values: {
      ...values,
      ...walls(draw),
      Q463: infeedInto(draw, values.Q463, deep),
      Q491: toDiameter(r1),
      Q492: z1,
      Q493: toDiameter(radius(r1 - out * widthOf(draw, mm(draw, 3, 18), tool.CUTWIDTH, values.Q483))),
      Q494: rounded(z1 - along * deep),
    },
    corner: at(z1, r1),
    contour: null,
    tool,
    start: at(z1 + along * mm(draw, 0, 6), Math.max(0.5, r1 + mm(draw, -5, 5))),
    blank: box(z1, z1 - along * 60, 0, 110),
  };
};

/** Set-ups of the radial recess-turning cycles: outside and inside, right and left wall first. */
export const radialRecesses = (draw: Draw): RecessSetup => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r1, z1] = [half(draw, 22, 50), mm(draw, -20, 5)];
  const [tool, values, deep] = [radialTool(draw, out), turnedValues(draw), mm(draw, 2, out > 0 ? 18 : 10)];
  return {
    values: {
      ...values,
      ...walls(draw),
      Q463: infeedInto(draw, values.Q463, deep),
      Q491: toDiameter(r1),
      Q492: z1,
      Q493: rounded(toDiameter(radius(r1 - out * deep))),
      Q494: z1 - along * widthOf(draw, mm(draw, 3, 28), tool.CUTWIDTH, 2 * values.Q484),
    },
    corner: at(z1, r1),
    contour: null,
    tool,
    start: at(z1 + mm(draw, -6, 6), Math.max(0.5, r1 + out * mm(draw, 0, 6))),
    blank: box(z1 - 60, z1 + 60, r1, out > 0 ? 0 : r1 + 40),
  };
};

/** Set-ups of the simple cycles, whose first corner is the tip at the call. */
export const simpleRecesses =
  (extended: (draw: Draw) => RecessSetup, transverse: boolean): Setups =>
  (draw) => {
    const { corner, ...drawn } = extended(draw);
    const { start, values } = drawn;
    const above = draw.one(0, mm(draw, 0, 3));
    return {
      ...drawn,
      values: Object.fromEntries(Object.entries(values).filter(([q]) => !OWN_CORNERS.includes(q))),
      start: transverse
        ? at(corner.z + Math.sign(start.z - corner.z) * above, corner.r)
        : at(corner.z, corner.r + Math.sign(start.r - corner.r) * above),
    };
  };

/** Parameters that the simple cycles do not have. */
const OWN_CORNERS = ["Q491", "Q492", "Q495", "Q501", "Q502", "Q500", "Q496", "Q503", "Q504"];

/**
 * Segments over and in a part: walls, floors, tapers, arcs, with corners between them; at most `depth` mm deep, from a
 * width of `wide` mm.
 */
function valleys(
  draw: Draw,
  depth: number,
): { along: number; deep: number; bulge: number; corner: "none" | "round" | "chamfer" }[] {
  const count = draw.whole(3, 9);
  let here = { along: 0, deep: mostly(draw, 0, mm(draw, 0, depth)) };
  const made = [{ ...here, bulge: 0, corner: "none" as "none" | "round" | "chamfer" }];
  for (let i = 1; i <= count; i += 1) {
    const kind = draw.one("wall", "floor", "slope", "slope");
    const deep = kind === "floor" ? here.deep : mm(draw, 0, depth);
    here = { along: rounded(here.along + (kind === "wall" ? 0 : mm(draw, 0.6, 12))), deep };
    made.push({
      ...here,
      bulge: kind === "wall" ? 0 : mostly(draw, 0, mm(draw, 0.6, 3)),
      corner: draw.one("none", "round", "chamfer"),
    });
  }
  return made;
}

/**
 * Set-ups of free recess-turning contours, in a cylinder, a bore or a face, in both directions, with limits on every
 * side.
 */
export const freeRecesses =
  (transverse: boolean): Setups =>
  (draw) => {
    const [out, way] = [transverse ? 1 : draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
    const [r0, z0] = transverse ? [mm(draw, 24, 30), mm(draw, -10, 5)] : [mm(draw, 26, 45), mm(draw, -10, 5)];
    const shape = valleys(draw, out > 0 ? 14 : 9);
    const whole = Math.max(...shape.map((p) => p.along));
    const place = (along: number, deep: number): Pt => {
      const run = way > 0 ? along : whole - along;
      return transverse ? at(rounded(z0 - deep), rounded(r0 + run)) : at(rounded(z0 - run), rounded(r0 - out * deep));
    };
    const made: ContourElement[] = [];
    shape.forEach((p, i) => {
      const [to, before] = [place(p.along, p.deep), shape[i - 1]];
      const chord = before ? Math.hypot(p.along - before.along, p.deep - before.deep) : 0;
      if (p.bulge > 0 && chord > 0.5)
        made.push({ kind: "radius", to, radius: rounded(chord * p.bulge), turn: draw.one("cw", "ccw") });
      else made.push({ kind: "line", to });
      if (p.corner !== "none" && i > 0 && i < shape.length - 1) made.push({ kind: p.corner, size: mm(draw, 0.2, 1.5) });
    });
    const built = contourFrom(made);
    if (whole < 4 || built.issues.some((i) => i.severity === "error")) return null;
    const points = built.segments.flatMap((s) => [s.from, s.to]);
    const above = draw.one(0, mm(draw, 0, 4));
    const first = points[0] as Pt;
    return {
      values: {
        ...turnedValues(draw),
        Q499: mostly(draw, 0, draw.one(1, 2)),
        ...dice.limits(draw, points),
      },
      contour: built.segments,
      tool: transverse ? axialTool(draw, 1) : radialTool(draw, out),
      start: transverse ? at(z0 + above, first.r) : at(first.z, Math.max(0.5, r0 + out * above)),
      blank: transverse ? box(z0, z0 - 60, 0, 120) : box(z0 + 40, z0 - whole - 40, r0, out > 0 ? 0 : r0 + 40),
    };
  };
