import { issue, type Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import type { Tool } from "../plan/tool.ts";

/** A depth divided evenly: as few passes as the greatest infeed allows, all of the same depth. */
export interface Division {
  readonly passes: number;
  readonly infeed: number;
}

/** More passes than this no one can mean (decision "Infeed"). */
export const MOST_PASSES = 2000;

/**
 * Into how many equal parts a length (mm) goes that are at most `most` mm long each. A length of exactly k such parts
 * is k of them, whatever rounding says; one that is longer by a step of the control is one more.
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
