import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { expect, test } from "vitest";
import {
  changedRequest,
  numbersOn,
  operationRequestAt,
  readOperationRequest,
  usualNumbers,
  type OperationRequest,
} from "./operation-request.ts";

const asked = (typed: Partial<OperationRequest["typed"]>): OperationRequest => ({
  site: "outside",
  shape: "step",
  stock: "solid",
  typed: { ...usualNumbers("outside", "step"), ...typed },
  rows: [],
});

test("another site keeps the typed numbers that fit it, and proposes new values for the others", () => {
  const before = asked({ d1: "81.3", d2: "53.7", z2: "-27.4" });
  const next = changedRequest(before, { site: "inside" }, new Set(["d2", "z2"]));
  expect(next.typed).toEqual({ ...usualNumbers("inside", "step"), d2: "53.7", z2: "-27.4" });
  expect(readOperationRequest(next).fault).toBeNull();
  const turned = changedRequest(before, { site: "inside" }, new Set(["d1", "d2", "z2"]));
  expect(readOperationRequest(turned).fault).toBeNull();
  expect(turned.typed.z2).toBe("-27.4");
});

test("another number changes nothing else", () => {
  const before = asked({ d1: "81.3" });
  const typed = { ...before.typed, d2: "90" };
  expect(changedRequest(before, { typed }, new Set(["d1"]))).toEqual({ ...before, typed });
});

test("a pre-turned part becomes solid where the shape is cut into a surface", () => {
  const before = { ...asked({}), stock: "preturned" as const };
  expect(changedRequest(before, { shape: "groove" }, new Set()).stock).toBe("solid");
});

const point = (z: number, x: number) => at(axial(z), toRadius(diameter(x)));
const chain = (...points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));

test.each([
  ["outside", "step", { d1: "90", d2: "60", z1: "0", z2: "-40" }],
  ["inside", "step", { d1: "36", d2: "60", z1: "0", z2: "-25" }],
  ["outside", "thread", { d1: "90", d2: "90", z2: "-25" }],
] as const)("numbers %s for a %s start on the surface of the stock", (site, shape, expected) => {
  const tube = [point(0, 36), point(0, 90), point(-80, 90), point(-80, 36)];
  expect(numbersOn([tube], site, shape)).toMatchObject(expected);
  expect(numbersOn([], site, shape)).toEqual(usualNumbers(site, shape));
});

test.each([
  ["groove", chain(point(-10, 60), point(-10, 50), point(-15, 50), point(-15, 60))],
  ["free", chain(point(-10, 60), point(-11, 50), point(-14, 50), point(-15, 60))],
  ["free", chain(point(-9, 62), point(-10, 60), point(-10, 50), point(-15, 50), point(-15, 60))],
] as const)("a contour section is asked for as it is: %s", (shape, contour) => {
  const region = { first: 0, last: contour.length - 1, site: "outside", stock: [], initialStock: "solid" } as const;
  expect(operationRequestAt({ contour, ...region }).shape).toBe(shape);
});
