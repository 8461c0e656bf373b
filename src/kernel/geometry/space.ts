import { arcFormsOf } from "./arc-forms.ts";
import { curvesOf } from "./curves.ts";
import { segmentsOf } from "./segments.ts";
import { vectorsOf, type Axes } from "./vectors.ts";

/**
 * The geometry of a space: points, lines and arcs, written once for any axes. There are three spaces, `part` (z, r),
 * `plane` (x, y) and `flat` (u, v); a point is converted only by the functions next to their types.
 */
export function spaceOf<P>(axes: Axes<P>) {
  const vectors = vectorsOf(axes);
  const segments = segmentsOf(axes, vectors);
  return { ...vectors, ...segments, ...curvesOf(vectors, segments), ...arcFormsOf(vectors, segments) };
}
