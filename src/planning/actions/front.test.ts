import { describe, expect, test } from "vitest";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { withoutEdge, withoutFront } from "./front.ts";

const chain = (...points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
const words = (segments: ReturnType<typeof withoutEdge>) =>
  segments?.map(({ from, to }) => [from, to].map(({ z, r }) => `${+z.toFixed(3)}/${+r.toFixed(3)}`).join(" ")) ?? null;

describe("a side without its front", () => {
  const marks = (count: number) => Array.from({ length: count }, (_, i) => ({ row: `e${i}` }));
  const rest = (...points: readonly Pt[]) => {
    const segments = chain(...points);
    const made = withoutFront({ segments, marks: marks(segments.length) });
    return [words(made.segments), made.marks.map(({ row }) => row)];
  };
  test("begins behind its faces, with the marks of what stays", () => {
    expect(rest(at(0, 0), at(0, 10), at(0, 15), at(-2, 17), at(-30, 17))).toEqual([
      ["0/15 -2/17", "-2/17 -30/17"],
      ["e2", "e3"],
    ]);
    expect(rest(at(0, 12), at(-30, 12), at(-30, 20))).toEqual([
      ["0/12 -30/12", "-30/12 -30/20"],
      ["e0", "e1"],
    ]);
    expect(rest(at(0, 0), at(0, 10))).toEqual([[], []]);
  });
  test("is the same for the same side", () => {
    const side = { segments: chain(at(0, 0), at(0, 10), at(-5, 10)), marks: marks(2) };
    expect(withoutFront(side)).toBe(withoutFront(side));
  });
});

describe("a section without the edge at its front", () => {
  test.each<[string, readonly Pt[], "outside" | "inside", readonly string[] | null]>([
    [
      "a chamfer: the wall goes on to the front",
      [at(0, 19.5), at(-0.5, 20), at(-30, 20), at(-30, 25)],
      "outside",
      ["0/20 -30/20", "-30/20 -30/25"],
    ],
    [
      "a chamfer before a cone: along its slope",
      [at(0, 19.5), at(-0.5, 20), at(-20.5, 22)],
      "outside",
      ["0/19.95 -20.5/22"],
    ],
    ["a chamfer of a bore", [at(0, 10.5), at(-0.5, 10), at(-30, 10)], "inside", ["0/10 -30/10"]],
    ["no chamfer, but a groove inside of the wall", [at(0, 20.5), at(-0.5, 20), at(-30, 20)], "outside", null],
    ["a bore that becomes narrower at its mouth", [at(0, 9.5), at(-0.5, 10), at(-30, 10)], "inside", null],
    ["an edge too thick for a finishing cut", [at(0, 8), at(-12, 20), at(-30, 20)], "outside", null],
    ["a face behind the edge", [at(0, 19.5), at(-0.5, 20), at(-0.5, 30)], "outside", null],
    ["a cylinder alone", [at(0, 20), at(-30, 20)], "outside", null],
    ["level with the wall", [at(0, 20), at(-5, 20), at(-30, 20)], "outside", null],
  ])("%s", (_, points, site, left) => expect(words(withoutEdge(chain(...points), site))).toEqual(left));
});
