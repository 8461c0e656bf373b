import { expect, test } from "vitest";
import { at, part } from "../../kernel/geometry/point.ts";
import { readRows } from "./contour-rows.ts";
import { rowsOf } from "./requested-shape.ts";

test("the rest of an arc that is shorter than what is typed does not become a circle", () => {
  const centre = at(-20, 10);
  const [top, near] = [at(-20, 20), at(-19.9999, 20)];
  const contour = [
    part.line(at(0, 8), at(-10, 10)),
    { kind: "arc", from: at(-10, 10), to: near, centre, turn: "ccw" },
    { kind: "arc", from: near, to: top, centre, turn: "ccw" },
    part.line(top, at(-30, 20)),
  ] as const;
  const { segments } = readRows(rowsOf(contour)).contour;
  expect(segments.map(({ kind, to }) => [kind, to])).toEqual([
    ["line", at(-10, 10)],
    ["arc", top],
    ["line", at(-30, 20)],
  ]);
});
