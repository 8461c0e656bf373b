import type { CornerElement } from "../kernel/contour/corner.ts";
import { withCorners } from "../kernel/contour/contour.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import type { Pt, Segment } from "../kernel/geometry/point.ts";

/** A chamfer (1) or a radius (2) of a start or end element; none for type 0. */
export const cornerElementOf = (type: number, size: number): CornerElement | null =>
  type === 0 || !(size > 0) ? null : { kind: type === 1 ? "chamfer" : "round", size };

/** A rounded inner corner; sharp when the radius is 0. */
export const roundOf = (radius: number): CornerElement | null => (radius > 0 ? { kind: "round", size: radius } : null);

/** A corner of a cycle's contour: its element, and the Q with its size. */
export interface NamedCorner {
  readonly element: CornerElement | null;
  readonly q: string;
}

/** A contour with the Q that shapes each segment. */
export interface NamedContour {
  readonly contour: readonly Segment[];
  readonly names: readonly string[];
  readonly issues: readonly Issue[];
}

/**
 * Joins points by lines, puts the elements on the inner points and drops the first and the last line, which only lead
 * in and out. `sides[i]` names the line from point i to point i + 1.
 */
export function namedContour(
  points: readonly Pt[],
  sides: readonly string[],
  corners: readonly NamedCorner[],
): NamedContour {
  const chain = points.slice(1).map((to, i): Segment => ({ kind: "line", from: points[i] as Pt, to }));
  const n = chain.length;
  const built = withCorners(
    chain,
    corners.map((c) => c.element),
    {
      segments: chain.map((_, i) => i),
      corners: corners.map((_, i) => n + i),
    },
  );
  const names = built.elements.map((e) => (e < n ? (sides[e] ?? "") : (corners[e - n]?.q ?? "")));
  const issues = built.issues.map((i) => {
    if (i.code !== "cornerElementTooLong") return i;
    const q = corners[i.data.element - n]?.q;
    const { element: _, ...data } = i.data;
    return issue("elementTooLong", "error", data, q);
  });
  const inner = built.segments
    .map((segment, i) => ({ segment, name: names[i] ?? "", element: built.elements[i] }))
    .filter((s) => s.element !== 0 && s.element !== n - 1);
  return { contour: inner.map((s) => s.segment), names: inner.map((s) => s.name), issues };
}

/** The number of segments that belong to the start element and to the end element of a contour. */
export function edgesOf(
  names: readonly string[],
  start: string,
  end: string,
): { readonly start: number; readonly end: number } {
  return { start: names.filter((n) => n === start).length, end: names.filter((n) => n === end).length };
}

/** Length of the legs beyond both ends of a contour: longer than any part, mm. */
export const LEG = 1e5;
