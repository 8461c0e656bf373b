import type { PathKind, Words } from "../../nc/words.ts";
import { programIssue, type ControlRule } from "./issue.ts";
import type { Machine } from "./machine.ts";
import { isArcPath, isPolarPath } from "./path.ts";

/** A printed rule of the control is broken in a block. */
export const breaksRule = (machine: Machine, rule: ControlRule, word: string, index: number): void =>
  machine.log.say(programIssue("controlRule", "error", { rule, word }), index);

/**
 * Whether a block names both coordinates of its plane; null where it names none, which leaves the point before as it
 * is. A mill's plane is that of its axes: Z alone is none of it.
 */
export function isWholePoint(path: PathKind, { axes }: Words, turning: boolean): boolean | null {
  if (isPolarPath(path)) return true;
  const named = ["X", "Y", "Z"].filter((axis) => axes.some((w) => w.axis === axis) && !(turning && axis === "Y"));
  if (named.length === 0 || (!turning && named.join("") === "Z")) return null;
  return named.length > 1;
}

/** RL or RR begins on a line: a control has no way to an arc that it does not know yet. */
export function sideBegins(machine: Machine, path: PathKind, { compensation: side }: Words, index: number): void {
  if ((side === "RL" || side === "RR") && machine.now.compensation === "R0" && isArcPath(path))
    breaksRule(machine, "sideOnArc", `${path} ${side}`, index);
}
