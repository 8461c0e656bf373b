/**
 * Code that the compiler must refuse. Nothing here runs: `tsc` reads it, and an expected error that does not occur is
 * itself an error.
 */
import { diameterParam, lengthParam, radial, type Values } from "../src/cycles/params.ts";
import { issue } from "../src/kernel/plan/issue.ts";
import type { Pt } from "../src/kernel/geometry/point.ts";
import {
  axial,
  diameter,
  radius,
  toDiameter,
  toRadius,
  type Axial,
  type Diameter,
  type Radius,
} from "../src/kernel/units.ts";

const d = diameter(60);
const r = radius(30);
const z = axial(-10);

export const halved: Radius = toRadius(d);
export const doubled: Diameter = toDiameter(r);

// @ts-expect-error A diameter is not a radius.
export const a: Radius = d;
// @ts-expect-error A radius is not a diameter.
export const b: Diameter = r;
// @ts-expect-error A position along the axis is not a distance from it.
export const c: Radius = z;
// @ts-expect-error A bare number has no unit.
export const e: Axial = -10;
// @ts-expect-error A mixed sum is a bare number.
export const f: Radius = r + d;
// @ts-expect-error A diameter is halved, never a radius.
export const g = toRadius(r);
// @ts-expect-error A point takes a radius.
export const h: Pt = { z, r: d };
// @ts-expect-error Points have names, never places.
export const i: Pt = [z, r];

export const params = {
  Q493: diameterParam("endDiameter", [-99999.999, 99999.999], 50),
  Q463: radial("depth", [0, 99.999], 3),
  Q460: lengthParam("gap", [0, 999.999], 2),
};
declare const values: Values<typeof params>;
export const j: Diameter = values.Q493;
export const k: Radius = values.Q463;
// @ts-expect-error Q493 is a diameter.
export const l: Radius = values.Q493;
// @ts-expect-error Q463 of this list is measured on the radius.
export const m: Diameter = values.Q463;
// @ts-expect-error This list has no such parameter.
export const n = values.Q999;

export const o = issue("outOfRange", "error", { value: 1, min: 2, max: 3, nearest: 2 }, "Q463");
// @ts-expect-error The data of an issue belong to its code.
export const p = issue("outOfRange", "error", { text: "x" });
// @ts-expect-error There is no such code.
export const q = issue("whatever", "error", {});
