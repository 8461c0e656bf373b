import { tipDirection } from "../../kernel/cutter/insert.ts";
import type { TipOrientation } from "../../kernel/plan/tool.ts";
import type { RunFinding } from "../../program/state/run-types.ts";

/** Where the values make a cycle cut: in a bore or outside, away from the chuck or towards it. */
export type WrongSide = "inside" | "outside" | "away" | "towards";

/**
 * The side on which the values make a cycle cut, where that is the opposite of the tool's side. A forgotten minus, a
 * radius for a diameter or a start point inside the material turns a cycle round, and the tool is refused. Null where
 * the tool itself is the wrong one.
 */
export function wrongSideOf(issue: RunFinding["issue"]): WrongSide | null {
  if (issue.code !== "toolUnfit") return null;
  const { type, types, orientation, orientations } = issue.data;
  if (!types.includes(type)) return null;
  const own = tipDirection(orientation as TipOrientation),
    asked = orientations.map((each) => tipDirection(each as TipOrientation));
  const way = (axis: "u" | "v") => Math.sign(asked.reduce((sum, tip) => sum + tip[axis], 0));
  const isTurned = (axis: "u" | "v") => way(axis) !== 0 && way(axis) === -Math.sign(own[axis]);
  if (isTurned("v")) return way("v") > 0 ? "inside" : "outside";
  if (isTurned("u")) return way("u") > 0 ? "away" : "towards";
  return null;
}
