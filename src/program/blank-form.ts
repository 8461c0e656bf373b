import { areaOf } from "../kernel/area.ts";
import { union } from "../kernel/clip.ts";
import { SAME, CHORD } from "../kernel/tolerance.ts";
import { part, type Pt, type Ring, type Segment } from "../kernel/point.ts";
import { axial, diameter, radius, toRadius, type Radius } from "../kernel/units.ts";

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
  return [[{ z: far, r: inside }, { z: near, r: inside }, { z: near, r: outside }, { z: far, r: outside }]];
}

/** A measure of the program as a radius, whether it was given as one or as a diameter. */
export const measured = (n: number, isDiameter: boolean): Radius => (isDiameter ? toRadius(diameter(n)) : radius(n));

/** The half section inside an outline. One that is not closed reaches down to the axis at both ends. */
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
