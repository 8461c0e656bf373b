import fc from "fast-check";
import { contourFrom, type ContourElement } from "../../src/kernel/contour.ts";
import type { TipOrientation } from "../../src/kernel/tool.ts";
import { anyOrientation, at, box, common, edge, mm, mostly, place, round, sign, startAt, toolAs, type Situation } from "./situation.ts";

const stretch = fc.record({
  across: fc.oneof({ weight: 2, arbitrary: mm(0.5, 6) }, { weight: 1, arbitrary: fc.constant(0) }),
  along: mm(-6, 6),
  corner: fc.constantFrom("none", "round", "chamfer"),
  size: mm(0.2, 1.5),
  // Now and then an arc: its radius in shares of the chord, and which way it turns.
  bulge: mostly(fc.constant(0), mm(0.6, 3)),
  turn: fc.constantFrom("cw" as const, "ccw" as const),
});

/** What a contour of random stretches ends with: where it is, on the axis, or a little past it. */
const ends = mostly(fc.constant<number | null>(null), fc.constantFrom<number | null>(0, -0.8, -0.4));

type Stretch = typeof stretch extends fc.Arbitrary<infer S> ? S : never;

const firstOf = (out: number, r: number) => (out > 0 ? r : r - 10);

function elementsOf(out: number, r: number, z: number, stretches: readonly Stretch[], ends: number | null): ContourElement[] {
  const first = firstOf(out, r);
  const elements: ContourElement[] = [{ kind: "line", to: at(z, first) }];
  let here = at(z, first);
  stretches.forEach((s, i) => {
    const rise = s.across === 0 ? Math.abs(s.along) + 0.5 : s.along;
    const to = at(round(here.z + rise), Math.max(0.5, round(here.r - out * s.across)));
    const chord = Math.hypot(to.z - here.z, to.r - here.r);
    if (s.bulge > 0 && chord > 0.5) elements.push({ kind: "radius", to, radius: round(chord * s.bulge), turn: s.turn });
    else elements.push({ kind: "line", to });
    here = to;
    if (s.corner !== "none" && i + 1 < stretches.length) elements.push({ kind: s.corner as "round" | "chamfer", size: s.size });
  });
  if (ends !== null && out > 0) elements.push({ kind: "line", to: at(here.z, ends) });
  return elements;
}

/**
 * Set-ups of the free contours, in both directions, with limits on every side. A contour that crosses itself is refused before
 * any cycle sees it.
 */
export const contour: fc.Arbitrary<Situation> = fc.record({
  ...common,
  Q499: mostly(fc.constant(0), fc.constantFrom(1, 2)),
  Q487: fc.constantFrom(0, 1),
  Q488: fc.constantFrom(0, 0.1),
  Q506: fc.constantFrom(0, 1, 2),
  Q479: fc.constantFrom(0, 0, 1),
  Q480: mm(0, 100),
  Q482: mm(-40, 10),
  out: sign,
  r: mm(26, 45),
  z: mm(-25, -5),
  stretches: fc.array(stretch, { minLength: 2, maxLength: 6 }),
  t: fc.constantFrom(15, 1, 2, 11),
  before: fc.oneof(fc.constant(0), mm(0, 3)),
  over: mm(0, 3),
  where: place,
  points: anyOrientation,
  edge,
  ends,
}).filter(({ out, r, z, stretches, ends }) =>
  contourFrom(elementsOf(out, r, z, stretches, ends)).issues.every((i) => i.severity !== "error")
).map(({ out, r, z, stretches, t, before, over, where, points, edge, ends, ...q }): Situation => {
  const first = firstOf(out, r);
  const built = contourFrom(elementsOf(out, r, z, stretches, ends)).segments;
  const top = Math.max(...built.flatMap((s) => [s.from.z, s.to.z]), z);
  const side: TipOrientation = t === 11 ? 8 : out > 0 ? 1 : 7;
  const blank = box(top, -90, first, out > 0 ? 0 : first + 80);
  return {
    values: q,
    given: { contour: built, start: null },
    tool: toolAs(t, points ?? side, edge),
    start: startAt(where, at(top + over, Math.max(0.5, first + out * before)), blank),
    blank: [blank],
  };
});
