import { issue, type Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";

/** A depth divided evenly: as few passes as the greatest infeed allows, all with the same infeed. */
export interface Division {
  readonly passes: number;
  readonly infeed: number;
}

/** Most passes: more are certainly unintended (decision "Infeed"). */
export const MOST_PASSES = 2000;

/**
 * Number of equal parts of at most `most` mm in a length (mm). A length of exactly k such parts gives k, whatever the
 * rounding; one longer by a step of the control gives one more.
 */
export const partsOf = (whole: number, most: number): number =>
  Math.max(1, Math.ceil((whole - SAME * Math.min(1, most)) / most));

/**
 * Divides `depth` mm into equal infeeds of at most `most` mm; 0 means one pass (decision "Infeed"). Null when there
 * would be too many, with the issue that says so.
 */
export function divide(depth: number, most: number, issues: Issue[]): Division | null {
  if (!(depth > SAME)) return { passes: 0, infeed: 0 };
  const passes = most > 0 ? partsOf(depth, most) : 1;
  if (passes <= MOST_PASSES) return { passes, infeed: depth / passes };
  const nearest = Math.ceil((depth / MOST_PASSES) * 1000 - SAME) / 1000;
  issues.push(issue("tooManyPasses", "error", { passes, most: MOST_PASSES, nearest }, "infeed"));
  return null;
}

/**
 * A CUTLENGTH smaller than the programmed infeed lowers it, with a warning (TNC7, 81762x-19, topic "Turning cycles").
 */
export function limitedInfeed(most: number, tool: Tool, depth: number, issues: Issue[]): number {
  const edge = tool.CUTLENGTH;
  const asked = most > 0 ? Math.min(most, Math.max(depth, 0)) : depth;
  if (edge === undefined || !(edge > 0) || asked <= edge) return most;
  issues.push(
    issue(
      "infeedOverCutLength",
      "warning",
      { infeed: most > 0 ? most : depth, cutLength: edge, nearest: edge },
      "infeed",
    ),
  );
  return edge;
}
