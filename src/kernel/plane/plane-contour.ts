import { compensate, type CentrePiece } from "./compensate.ts";
import { withCorners } from "../contour/contour.ts";
import type { CornerElement } from "../contour/corner.ts";
import type { Issue } from "../plan/issue.ts";
import { partSegment, plane, planeSegment, type PlaneSegment, type Side } from "./plane.ts";
import { SAME } from "../tolerance.ts";

/** A programmed element, and the rounding or chamfer on the corner behind it. */
export interface PlaneElement {
  readonly segment: PlaneSegment;
  readonly corner?: CornerElement;
}

/** A piece of the contour with roundings and chamfers. */
export interface ContourPart {
  readonly segment: PlaneSegment;
  /** Index of its element. */
  readonly element: number;
  /** True for the rounding or chamfer behind that element. */
  readonly onCorner: boolean;
}

export interface PlaneContour {
  /** The contour as programmed, roundings and chamfers included. */
  readonly contour: readonly ContourPart[];
  /** The path of the tool centre; `part` "corner" is the arc round an outer corner. */
  readonly path: readonly (ContourPart & { readonly part: CentrePiece["part"] })[];
  /** `element` and `onCorner` identify the faulty element. */
  readonly issues: readonly { readonly issue: Issue; readonly element: number; readonly onCorner: boolean }[];
}

const NOWHERE = { element: 0, onCorner: false };

/** Puts roundings and chamfers on a chain of elements and compensates it. */
export function planeContour(elements: readonly PlaneElement[], side: Side, toolRadius: number): PlaneContour {
  const kept = elements.flatMap((e, element) => (plane.lengthOf(e.segment) > SAME ? [{ ...e, element }] : []));
  const chain = kept.map((e) => partSegment(e.segment));
  const made = withCorners(
    chain,
    kept.map((e) => e.corner ?? null),
    {
      segments: kept.map((_, i) => i + 1),
      corners: kept.map((_, i) => -i - 1),
    },
  );
  const place = (n: number) => ({ element: kept[Math.abs(n) - 1]?.element ?? 0, onCorner: n < 0 });
  const contour = made.segments.map((s, i): ContourPart => ({
    segment: planeSegment(s),
    ...place(made.elements[i] ?? 1),
  }));
  const centre = compensate(
    contour.map((c) => c.segment),
    side,
    toolRadius,
  );
  return {
    contour,
    path: centre.pieces.map(({ segment, element, part }) => ({ ...(contour[element] ?? NOWHERE), segment, part })),
    issues: [
      ...made.issues.map((found) => numbered(found, place("element" in found.data ? found.data.element : 1))),
      ...centre.issues.map((found) =>
        numbered(found, contour["element" in found.data ? found.data.element - 1 : 0] ?? NOWHERE),
      ),
    ],
  };
}

/** The finding with the number of the programmed element it belongs to, from 1. */
const numbered = (found: Issue, { element, onCorner }: { element: number; onCorner: boolean }) => ({
  issue: { ...found, data: { ...found.data, element: element + 1 } } as Issue,
  element,
  onCorner,
});
