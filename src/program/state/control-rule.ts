import type { PathKind, Words } from "../../nc/words.ts";
import { programIssue, type ControlRule } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { isArcPath, isPolarPath } from "./path.ts";

/** Reports a block that breaks a printed rule of the control. */
export const breaksRule = (machine: Machine, rule: ControlRule, word: string, index: number): void =>
  machine.log.report(programIssue("controlRule", "error", { rule, word }), index);

/**
 * Whether a block names both coordinates of its plane; null where it names none, which keeps the previous answer. Z
 * alone does not belong to the plane of a mill.
 */
export function isWholePoint(path: PathKind, { axes }: Words, turning: boolean): boolean | null {
  if (isPolarPath(path)) return true;
  const named = ["X", "Y", "Z"].filter((axis) => axes.some((w) => w.axis === axis) && !(turning && axis === "Y"));
  if (named.length === 0 || (!turning && named.join("") === "Z")) return null;
  return named.length > 1;
}

/** RL or RR must begin on a line: a control cannot approach an unknown arc. */
export function sideBegins(machine: Machine, path: PathKind, { compensation: side }: Words, index: number): void {
  if ((side === "RL" || side === "RR") && machine.now.compensation === "R0" && isArcPath(path))
    breaksRule(machine, "sideOnArc", `${path} ${side}`, index);
}
