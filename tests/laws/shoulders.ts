import fc from "fast-check";
import type { TipOrientation } from "../../src/kernel/tool.ts";
import { anyOrientation, at, box, common, deg, edge, elements, mm, orZero, place, round, sign, startAt, toolAs,
  type Situation } from "./situation.ts";

/** Set-ups of the shoulder cycles: outside and inside, towards −Z and +Z. */
export const shoulder: fc.Arbitrary<Situation> = fc.record({
  ...common,
  ...elements,
  Q495: orZero(deg(20)),
  Q496: orZero(deg(30)),
  Q506: fc.constantFrom(0, 1, 2),
  out: sign,
  along: sign,
  d1: mm(40, 100),
  height: mm(2, 30),
  z1: mm(-5, 5),
  length: mm(3, 70),
  t: fc.constantFrom(1, 2, 4, 11),
  before: mm(0, 8),
  over: mm(-2, 6),
  level: fc.boolean(),
  where: place,
  points: anyOrientation,
  edge,
}).map(({ out, along, d1, height, z1, length, t, before, over, level, where, points, edge, ...q }): Situation => {
  const z2 = round(z1 - along * length);
  const side: TipOrientation = out > 0 ? (along > 0 ? 1 : 3) : along > 0 ? 7 : 5;
  const button = t === 11 ? (out > 0 ? 2 : 6) : side;
  const r1 = d1 / 2;
  const blank = box(z1, z2 - along * 30, r1, out > 0 ? 0 : r1 + 60);
  return {
    values: { ...q, Q491: d1, Q492: z1, Q493: round(d1 - out * height), Q494: z2 },
    given: { contour: null, start: null },
    tool: toolAs(t, points ?? button, edge),
    start: startAt(where, at(z1 + along * before, Math.max(0.5, level ? r1 : r1 + out * over)), blank),
    blank: [blank],
  };
});
