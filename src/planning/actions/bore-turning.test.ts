import { expect, test } from "vitest";
import { at, part as geometry, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Chain, PlannedPart } from "../types.ts";
import { insideRegions } from "./bore.ts";
import { sectionInBore } from "./bore-turning.ts";

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
