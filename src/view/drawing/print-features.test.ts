import { expect, test } from "vitest";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { printFeatures } from "./print-features.ts";

const chain = (...points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));

test("bevels at both ends of an outline are chamfers, and corners count as if they were sharp", () => {
  // A bore: 0.7×45° at its mouth, ⌀40.2 to Z−31.3, and 0.4 where it runs out on the blank.
  const { corners, cylinders, positions } = printFeatures(
    chain(at(0, 20.8), at(-0.7, 20.1), at(-31.3, 20.1), at(-31.3, 12.4), at(-31.7, 12)),
  );
  expect(corners.map((c) => [c.kind, Number(c.size.toFixed(6))])).toEqual([
    ["chamfer", 0.7],
    ["chamfer", 0.4],
  ]);
  expect(cylinders.map(({ r }) => r)).toEqual([20.1]);
  expect(positions.map(({ z }) => z)).toEqual([-31.3]);
});

test("an end of a cone within rounding of a hundredth is at that hundredth", () => {
  const { cylinders } = printFeatures(
    chain(at(0, 0), at(0, 14.2), at(-9.1, 15.0509), at(-20, 17.2541), at(-31.3, 17.2573), at(-31.3, 30)),
  );
  expect(cylinders.map(({ r }) => Number(r.toFixed(4)))).toEqual([14.2, 15.05, 17.255, 17.2573]);
});

test("a cone is no chamfer, however it stands between two cylinders", () => {
  const { corners, cylinders } = printFeatures(
    chain(at(0, 0), at(0, 14.2), at(-11.7, 14.2), at(-19.9, 18.3), at(-30, 18.3)),
  );
  expect(corners).toEqual([]);
  expect(cylinders.map(({ r }) => r)).toEqual([14.2, 18.3]);
});

test("a cone of a usual angle is stated by one diameter and the angle; a chamfer beside it by its legs", () => {
  const end = 25 + 55 * Math.tan((5 * Math.PI) / 180);
  // 0.5 off the face at ⌀50, and 0.5 along the axis on the cone.
  const begins = 25 + 0.5 * Math.tan((5 * Math.PI) / 180);
  const { corners, cylinders } = printFeatures(
    chain(at(0, 10), at(0, 24.5), at(-0.5, begins), at(-55, end), at(-55, 40)),
  );
  expect(cylinders.map(({ r, follows }) => [Number(r.toFixed(3)), follows])).toEqual([
    [25, false],
    [Number(end.toFixed(3)), true],
  ]);
  expect(corners).toMatchObject([
    { kind: "chamfer", size: 0.5, across: 0.5 },
    { kind: "angle", size: 5 },
  ]);
});

test("a cone whose end is near a hundredth by chance is stated by its angle too", () => {
  const { corners, cylinders } = printFeatures(chain(at(0, 10), at(0, 25), at(-54.99, 29.811), at(-54.99, 40)));
  expect(cylinders.map(({ follows }) => follows)).toEqual([false, true]);
  expect(corners).toMatchObject([{ kind: "angle", size: 5 }]);
});

test("a cone of another angle keeps both diameters", () => {
  const { corners, cylinders } = printFeatures(
    chain(at(0, 10), at(0, 25), at(-40, 25 + 40 * Math.tan(0.0811)), at(-40, 40)),
  );
  expect(cylinders.map(({ follows }) => follows)).toEqual([false, false]);
  expect(corners).toEqual([]);
});
