import type { PlanePoint } from "../../kernel/plane.ts";
import type { LookAt } from "../lathe/places.ts";

/** A place where the way onto a contour cuts it, with the start or end point that is free. */
export interface CutPlace extends LookAt {
  readonly free: PlanePoint | null;
  /** Which point it is. */
  readonly point: "PS" | "PN";
}

/** What a finding of the check of approach and departure proposes beside its place. */
export function cutPlace(place: LookAt): CutPlace | null {
  const { issue } = place;
  if (issue?.code !== "approachCutsContour" && issue?.code !== "approachValueCutsContour" && issue?.code !== "approachBlocked") return null;
  const free = issue.code === "approachCutsContour" && issue.data.freeY !== undefined ? { x: issue.data.freeX, y: issue.data.freeY } : null;
  return { ...place, free, point: issue.data.point };
}
