import { describe, expect, test } from "vitest";
import { boxOf } from "../../kernel/area/box.ts";
import { at, part as geometry, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Chain, PlannedPart } from "../types.ts";
import { insideRegions } from "./bore.ts";
import { sectionInBore, withinRear } from "./bore-turning.ts";

const chainOf = (points: readonly Pt[]): Chain => ({
  segments: points.slice(1).map((to, i) => geometry.line(points[i] ?? to, to)),
  marks: points.slice(1).map((_, i) => ({ row: `e${i}` })),
});

/** A wide bore, and behind it a taper that ends in the cone of a drill. */
const inner = [at(0, 9), at(-22, 9), at(-22, 6), at(-38, 5), at(-41, 0)];
const outer = [at(0, 9), at(0, 15), at(-60, 15)];
const part: PlannedPart = {
  name: "CUP",
  outside: chainOf(outer),
  inside: chainOf(inner),
  rings: [[...outer, at(-60, 0), ...inner.toReversed()].toReversed()],
};
/** The same drilled with ⌀9; `wide`: radius of the bore in front. */
const drilled = (wide: number): readonly Ring[] => [
  [at(0, 15), at(-90, 15), at(-90, 0), at(-40.7, 0), at(-38, 4.5), at(-21.8, 4.5), at(-21.8, wide), at(0, wide)],
];

test.each([
  ["from the front of the bore", 8.6, 0],
  ["behind a wall that stands already", 9, -22],
])("a cut %s ends where the cone of a drill begins, across its wall", (_, wide, from) => {
  const stock = drilled(wide);
  const [region] = insideRegions(stock, part);
  const segments = (region && sectionInBore(stock, part, region)?.segments) ?? [];
  const [first, last] = [segments[0], segments.at(-1)];
  expect(first?.from.z).toBeCloseTo(from, 2);
  expect(last?.to.z).toBe(last?.from.z);
  expect(last?.to.z).toBeCloseTo(-38.1, 1);
  expect(last?.from.r).toBeGreaterThan(4.5);
  expect(last?.to.r).toBeLessThan(4.5);
});

describe("a bore that is wider behind a neck", () => {
  const wide = [at(0, 10), at(-8, 10), at(-8, 13), at(-30, 13)];
  const ring: PlannedPart = {
    name: "RING",
    outside: chainOf([at(0, 10), at(0, 20), at(-30, 20)]),
    inside: chainOf(wide),
    rings: [[...wide, at(-30, 20), at(0, 20)].toReversed()],
  };
  const sectionOf = (inner: readonly Pt[], thick = 0, oversize = 0) => {
    const [region] = insideRegions([[at(0, 20), at(-60, 20), at(-60, 9), ...inner]], ring, thick);
    return region && sectionInBore([[at(0, 20), at(-60, 20), at(-60, 9), ...inner]], ring, region, { oversize });
  };
  const words = (section: ReturnType<typeof sectionOf>) =>
    section?.segments.map(({ to: { z, r } }) => `${z.toFixed(1)}/${r.toFixed(1)}`).join(" ");

  test("is finished past the end of the neck, where the nose radius would leave its corner, and then off the wall", () => {
    const front = {
      rings: [[at(-8, 9), at(0, 9), at(0, 10), at(-8, 10)]],
      area: 8,
      box: boxOf([at(-8, 9), at(0, 10)]),
    };
    const stock = [[at(0, 20), at(-60, 20), at(-60, 9), at(0, 9)]];
    expect(words(sectionInBore(stock, ring, front))).toBe("-8.0/10.0 -9.0/10.0 -10.2/8.8");
  });

  test.each([
    ["with its shoulder", 0],
    ["whose shoulder is left to finishing", 2.5],
  ])("behind it begins in the neck, %s", (_, thick) => {
    const section = sectionOf([at(-8, 9), at(-8, 10), at(0, 10)], thick);
    expect(section?.segments[0]?.from).toMatchObject({ z: -6, r: 10 });
    expect(section?.way.z).toBeCloseTo(-4, 2);
    expect(words(section)).toContain("-8.0/10.0 -8.0/13.0 -30.0/13.0 -31.0/13.0");
  });

  test.each([
    ["neck", 10],
    ["roughed neck", 9.75],
  ])("begins in the %s too where the place behind it is wide already", (_, clear) => {
    const section = sectionOf([at(-15, 9), at(-15, 12.75), at(-8, 12.75), at(-8, clear), at(0, clear)], 2.5, 0.25);
    expect(section?.segments[0]?.from).toMatchObject({ z: -6, r: 10 });
    expect(section?.way).toMatchObject({ z: expect.closeTo(-4, 2), clear });
    expect(words(section)).toContain("-8.0/10.0 -8.0/13.0 -30.0/13.0");
  });

  test.each([
    ["a bar with a nose", 0, wide, -31],
    ["a blade: ends earlier by its width", 2, wide, -29],
    ["a blade wider than its last cylinder: where that begins", 2, [at(0, 10), at(-29.5, 10), at(-30, 10.5)], -30],
  ])("behind the part, for %s", (_, width, points, end) => {
    const { segments } = chainOf([...points, at(-31, points.at(-1)?.r ?? 0)]);
    expect(withinRear(segments, width, { ...ring, inside: chainOf(points) }).at(-1)?.to.z).toBeCloseTo(end, 6);
  });
});
