import fc from "fast-check";
import { length } from "../../src/kernel/units.ts";
import { anyOrientation, at, box, common, deg, edge, elements, mm, mostly, orZero, place, round, sign, startAt, toolAs,
  type Situation } from "./situation.ts";

/** Set-ups of the recess-turning cycles: outer and inner wall first, from +Z and from −Z. */
export const recess: fc.Arbitrary<Situation> = fc.record({
  ...common,
  ...elements,
  Q495: orZero(deg(10)),
  Q496: orZero(deg(10)),
  Q507: fc.constantFrom(0, 1),
  Q508: orZero(mm(0, 1)),
  Q509: mostly(fc.constant(0), mm(-0.3, 0.3)),
  Q488: fc.constantFrom(0, 0.05),
  out: sign,
  along: sign,
  d1: mm(40, 100),
  width: mm(3, 18),
  z1: mm(-20, 5),
  depth: mm(2, 28),
  before: mm(0, 6),
  across: mm(-5, 5),
  CUTWIDTH: fc.constantFrom(2, 3, 4),
  RS: fc.constantFrom(0, 0.2, 0.4),
  where: place,
  points: anyOrientation,
  edge,
}).map(({ out, along, d1, width, z1, depth, before, across, CUTWIDTH, RS, where, points, edge, ...q }): Situation => {
  const blank = box(z1, z1 - along * 60, 0, 110);
  return {
    values: { ...q, Q491: d1, Q492: z1, Q493: round(d1 - out * 2 * width), Q494: round(z1 - along * depth) },
    given: { contour: null, start: null },
    tool: { ...toolAs(8, points ?? (along > 0 ? 8 : 4), edge), CUTWIDTH: length(CUTWIDTH), RS: length(RS) },
    start: startAt(where, at(z1 + along * before, Math.max(0.5, d1 / 2 + across)), blank),
    blank: [blank],
  };
});
