import { partPoint } from "../../kernel/plane.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import type { PlaneStep } from "../../program/plane-types.ts";
import type { Finding } from "../../program/run-types.ts";
import type { PlanePoint } from "../../kernel/plane.ts";
import type { LookAt } from "../lathe/places.ts";

/** A place where the way onto a contour cuts it, with the start or end point that is free. */
export interface CutPlace extends LookAt {
  readonly free: PlanePoint | null;
  /** Which point it is. */
  readonly point: "PS" | "PN";
}

/** Findings of the check of approach and departure that have a place in the X/Y plane. */
export function cutPlaces(
  issues: readonly Finding[], steps: readonly PlaneStep[], say: (issue: AnyIssue) => string, line: (block: string, sentence: string) => string,
): readonly CutPlace[] {
  const found: CutPlace[] = [];
  for (const { issue, block } of issues) {
    if (issue.code !== "approachCutsContour" && issue.code !== "approachValueCutsContour" && issue.code !== "approachBlocked") continue;
    const { x, y } = issue.data;
    if (y === undefined) continue;
    const free = issue.code === "approachCutsContour" && issue.data.freeY !== undefined ? { x: issue.data.freeX, y: issue.data.freeY } : null;
    const step = steps.findIndex((s) => s.block === block);
    found.push({
      id: `c${found.length}`, kind: "finding", mark: String(found.length + 1), place: partPoint({ x, y }), line: line(String(block ?? ""), say(issue)),
      position: { step: Math.max(0, step), fraction: 0.5 }, free, point: issue.data.point,
    });
  }
  return found;
}
