import type { Cuboid } from "../../kernel/area/box.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { union } from "../../kernel/area/clip.ts";
import { SAME, CHORD } from "../../kernel/tolerance.ts";
import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, toRadius, type Radius } from "../../kernel/units.ts";

interface Cylinder {
  readonly outside: Radius;
  readonly inside: Radius;
  /** From the front face into the chuck, mm. */
  readonly length: number;
  /** Z of the front face. */
  readonly front: number;
}

/** The half section of a cylinder, or null when its measures are impossible. */
export function cylinder({ outside, inside, length, front }: Cylinder): Ring[] | null {
  if (!(outside > inside) || !(inside >= 0) || !(length > 0) || !Number.isFinite(outside + length + front)) return null;
  const [near, far] = [axial(front), axial(front - length)];
  return [
    [
      { z: far, r: inside },
      { z: near, r: inside },
      { z: near, r: outside },
      { z: far, r: outside },
    ],
  ];
}

/** A corner of a box; null: not given, or not known. */
export interface BoxCorner {
  readonly x: number | null;
  readonly y: number | null;
  readonly z: number | null;
}

/** A rotating box: the cylinder around its corners, and the radius within which material is all round. */
export interface TurnedBox {
  readonly rings: Ring[];
  readonly outer: Radius;
  readonly inner: Radius;
}

const lowAndHigh = (a: number | null, b: number | null): readonly [number, number] => [
  Math.min(a ?? NaN, b ?? NaN),
  Math.max(a ?? NaN, b ?? NaN),
];

/** Box between two corners: "unknown" when a coordinate is unknown, "impossible" when it has no volume. */
export function boxBetween(a: BoxCorner, b: BoxCorner): Cuboid | "impossible" | "unknown" {
  const [[left, right], [low, high], [bottom, top]] = [
    lowAndHigh(a.x, b.x),
    lowAndHigh(a.y, b.y),
    lowAndHigh(a.z, b.z),
  ];
  if (![left, right, low, high, bottom, top].every(Number.isFinite)) return "unknown";
  const isSolid = right - left > SAME && high - low > SAME && top - bottom > SAME;
  return isSolid ? { left, right, low, high, bottom, top } : "impossible";
}

/**
 * Body of a box rotating about X0 Y0: its corners sweep a cylinder. "impossible" when it has no volume, "beside" when
 * the axis misses it, "unknown" when a coordinate is unknown.
 */
export function turnedBox(a: BoxCorner, b: BoxCorner): TurnedBox | "impossible" | "beside" | "unknown" {
  const box = boxBetween(a, b);
  if (typeof box === "string") return box;
  const { left, right, low, high, bottom: far, top: near } = box;
  const inner = Math.min(-left, right, -low, high);
  if (!(inner > 0)) return "beside";
  const outer = radius(Math.hypot(Math.max(-left, right), Math.max(-low, high)));
  const rings = cylinder({ outside: outer, inside: radius(0), length: near - far, front: near });
  return rings ? { rings, outer, inner: radius(inner) } : "impossible";
}

/** A program dimension as a radius, whether given as radius or diameter. */
export const measured = (n: number, isDiameter: boolean): Radius => (isDiameter ? toRadius(diameter(n)) : radius(n));

/** Half section inside an outline. An open outline is extended to the axis at both ends. */
export function rotation(outline: readonly Segment[]): Ring[] | null {
  const [first, last] = [outline[0]?.from, outline.at(-1)?.to];
  if (!first || !last) return null;
  const points: Pt[] = outline.flatMap((s) => part.flattened(s, CHORD).slice(1));
  points.unshift(first);
  const closed = Math.hypot(first.z - last.z, first.r - last.r) <= SAME;
  const foot = (p: Pt): Pt => ({ z: p.z, r: radius(0) });
  const rings = union([closed ? points.slice(1) : [foot(first), ...points, foot(last)]]);
  return Math.abs(areaOf(rings)) > SAME ? rings : null;
}
