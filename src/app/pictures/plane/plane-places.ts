import type { PlanePoint } from "../../../kernel/plane/plane.ts";
import type { PicturePlace } from "../lathe/places.ts";

/** A place where a tool cuts a contour, with the free start or end point if the check proposes one. */
export interface CutPlace extends PicturePlace {
  readonly free: { readonly at: PlanePoint; readonly point: "PS" | "PN" } | null;
}

/** The proposed point of an approach or departure finding, added to its place. */
export function cutPlace(place: PicturePlace): CutPlace {
  const { issue } = place;
  return issue?.code === "approachCutsContour" && issue.data.freeY !== undefined
    ? { ...place, free: { at: { x: issue.data.freeX, y: issue.data.freeY }, point: issue.data.point } }
    : { ...place, free: null };
}
