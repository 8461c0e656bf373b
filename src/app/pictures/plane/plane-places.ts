import type { PlanePoint } from "../../../kernel/plane/plane.ts";
import type { LookAt } from "../lathe/places.ts";

/** A place where a tool cuts a contour, with the free start or end point if the check proposes one. */
export interface CutPlace extends LookAt {
  readonly free: { readonly at: PlanePoint; readonly point: "PS" | "PN" } | null;
}

/** The proposed point of an approach or departure finding, added to its place. */
export function cutPlace(place: LookAt): CutPlace {
  const { issue } = place;
  return issue?.code === "approachCutsContour" && issue.data.freeY !== undefined
    ? { ...place, free: { at: { x: issue.data.freeX, y: issue.data.freeY }, point: issue.data.point } }
    : { ...place, free: null };
}
