import { at, type Pt } from "../kernel/point.ts";
import { radius, rounded, toDiameter } from "../kernel/units.ts";
import { dice, type Draw, type DrawnSetup, type Setups } from "./drawn-setup.ts";

const { angle, box, common, elements, half, mm, mostly } = dice;

/** A set-up of a recess, with its first corner. */
interface RecessSetup extends DrawnSetup {
  readonly corner: Pt;
}

/** Values that every recess-turning cycle has. */
export const turnedValues = (draw: Draw) => ({
  ...common(draw),
  Q507: draw.one(0, 1),
  Q508: draw.one(0, mm(draw, 0, 1)),
  Q509: mostly(draw, 0, mm(draw, -0.3, 0.3)),
  Q488: draw.one(0, 0.05),
});
/** Walls and corners of the recesses that have them. */
const walls = (draw: Draw) => ({ ...elements(draw), Q495: draw.one(0, angle(draw, 10)), Q496: draw.one(0, angle(draw, 10)) });

const axialTool = (draw: Draw, along: 1 | -1) => ({
  T: 8,
  TO: along > 0 ? 8 as const : 4 as const,
  CUTWIDTH: draw.one(2, 3, 4),
  RS: draw.one(0, 0.2, 0.4),
});
/** A bar that points at the axis or away from it, its tip in the middle of the edge or at either corner. */
export const radialTool = (draw: Draw, out: 1 | -1) => ({
  T: out > 0 ? 9 : 14,
  TO: out > 0 ? mostly(draw, 2 as const, draw.one(1 as const, 3 as const)) : mostly(draw, 6 as const, draw.one(5 as const, 7 as const)),
  CUTWIDTH: draw.one(2, 3, 4),
  RS: draw.one(0, 0.2, 0.4),
});

/** Set-ups of the axial recess-turning cycles: outer and inner wall first, from +Z and from −Z. */
export const axialRecesses = (draw: Draw): RecessSetup => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r1, z1] = [half(draw, 20, 50), mm(draw, -20, 5)];
  return {
    values: {
      ...turnedValues(draw),
      ...walls(draw),
      Q491: toDiameter(r1),
      Q492: z1,
      Q493: rounded(toDiameter(radius(r1 - out * mm(draw, 3, 18)))),
      Q494: rounded(z1 - along * mm(draw, 2, 28)),
    },
    corner: at(z1, r1),
    contour: null,
    tool: axialTool(draw, along),
    start: at(z1 + along * mm(draw, 0, 6), Math.max(0.5, r1 + mm(draw, -5, 5))),
    blank: box(z1, z1 - along * 60, 0, 110),
  };
};

/** Set-ups of the radial recess-turning cycles: outside and inside, right and left wall first. */
export const radialRecesses = (draw: Draw): RecessSetup => {
  const [out, along] = [draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r1, z1] = [half(draw, 22, 50), mm(draw, -20, 5)];
  return {
    values: {
      ...turnedValues(draw),
      ...walls(draw),
      Q491: toDiameter(r1),
      Q492: z1,
      Q493: rounded(toDiameter(radius(r1 - out * mm(draw, 2, out > 0 ? 18 : 10)))),
      Q494: rounded(z1 - along * mm(draw, 3, 28)),
    },
    corner: at(z1, r1),
    contour: null,
    tool: radialTool(draw, out),
    start: at(z1 + mm(draw, -6, 6), Math.max(0.5, r1 + out * mm(draw, 0, 6))),
    blank: box(z1 - 60, z1 + 60, r1, out > 0 ? 0 : r1 + 40),
  };
};

/** The same for the simple cycles, whose first corner is the tip at the call. */
export const simpleRecesses = (extended: (draw: Draw) => RecessSetup, transverse: boolean): Setups => (draw) => {
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

/** What the simple cycles do not ask for. */
const OWN_CORNERS = ["Q491", "Q492", "Q495", "Q501", "Q502", "Q500", "Q496", "Q503", "Q504"];
