import { expect, test } from "vitest";
import { threadRoles } from "./thread-params.ts";
import { sizesNamed, threadSizes, valuesOf } from "./thread-sizes.ts";

const named = (typed: string) => sizesNamed(typed).map((s) => s.name);

test("a size is found however it is typed", () => {
  expect(named("M20×1.5")).toEqual(["M20×1.5"]);
  expect(named("m20x1,5")).toEqual(["M20×1.5"]);
  expect(named("M20")).toEqual(["M20", "M20×2", "M20×1.5", "M20×1"]);
  expect(named("M20x2.5")).toEqual(["M20"]);
  // A diameter without a coarse pitch is no size by itself.
  expect(named("M40")).toEqual(["M40×3", "M40×2", "M40×1.5"]);
  expect(named("G½")).toEqual(["G1/2"]);
  expect(named('g 1 1/2"')).toEqual(["G1 1/2"]);
  expect(named("Tr 20 x 4")).toEqual(["Tr20×4"]);
  expect(named("Tr2")[0]).toBe("Tr20×4");
  expect(named("")).toEqual([]);
  expect(named("W20")).toEqual([]);
});

test.each([
  ["M77x1.5", "M77×1.5", 77, 1.5, 0.92],
  ["m 33,5 * 0,75", "M33.5×0.75", 33.5, 0.75, 0.46],
  ["Tr 48x3", "Tr48×3", 48, 3, 1.75],
  ["1/4-20 UNC", "1/4-20 UNC", 6.35, 1.27, 0.779],
  ['1 1/2"-12', "1 1/2-12 UN", 38.1, 2.117, 1.299],
  ["#10-32 unf", "#10-32 UNF", 4.826, 0.794, 0.487],
  ["10-32", "10-32 UN", 4.826, 0.794, 0.487],
])("%s is computed from diameter and pitch", (typed, name, diameter, pitch, depth) => {
  expect(sizesNamed(typed)[0]).toMatchObject({ name, pitch, outside: { diameter, depth } });
});

test.each(["M2x1.5", "M0x1", "M77x", "M77x0", "Tr5000x4", "1/4-200", "20-"])("%s is no thread", (typed) => {
  expect(named(typed)).toEqual([]);
});

test("it gives pitch, depth and diameter, one start, and no infeed steeper than its flank", () => {
  const roles = threadRoles("Q491", "Q493");
  const values = (name: string, inside: boolean) => valuesOf(sizesNamed(name)[0] ?? threadSizes[0]!, roles, inside, 30);
  expect(values("M20x1.5", false)).toEqual({ Q472: 1.5, Q473: 0.92, Q475: 1, Q491: 20, Q493: 20 });
  expect(values("M20x1.5", true)).toEqual({ Q472: 1.5, Q473: 0.812, Q475: 1, Q491: 20, Q493: 20 });
  expect(values("G1/2", false)).toEqual({ Q472: 1.814, Q473: 1.162, Q475: 1, Q491: 20.955, Q493: 20.955, Q467: 27.5 });
  // Core of the external thread 15.5; root of the internal one 20.5 and its core 16.
  expect(values("Tr20x4", false)).toEqual({ Q472: 4, Q473: 2.25, Q475: 1, Q491: 20, Q493: 20, Q467: 15 });
  expect(values("Tr20x4", true)).toEqual({ Q472: 4, Q473: 2.25, Q475: 1, Q491: 20.5, Q493: 20.5, Q467: 15 });
});

test("no size occurs twice, and none is deeper than its pitch", () => {
  expect(new Set(threadSizes.map((s) => s.name)).size).toBe(threadSizes.length);
  for (const s of threadSizes) {
    expect([s.name, s.outside.depth > s.pitch / 2 && s.outside.depth < s.pitch]).toEqual([s.name, true]);
    expect([s.name, s.inside.depth > s.pitch / 2 && s.inside.depth < s.pitch]).toEqual([s.name, true]);
  }
});
