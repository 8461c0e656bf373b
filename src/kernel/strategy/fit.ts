import type { Flat, Frame } from "../geometry/flat.ts";
import { toFlat } from "../geometry/flat.ts";
import { extent } from "../reach/convex.ts";
import { isBar, noseRadius, tipDirection } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { at } from "../geometry/point.ts";
import { SAME } from "../tolerance.ts";
import type { TipOrientation, Tool, ToolType } from "../plan/tool.ts";
import { insertIn } from "./ground.ts";

const EVERY: readonly TipOrientation[] = [1, 2, 3, 4, 5, 6, 7, 8, 9];

/** Why a tool cannot cut a thread: of another TYPE, or its tip does not point straight into the material. */
export function unfitForThread(tool: Tool, frame: Frame): Issue | null {
  const square = (TO: TipOrientation) => {
    const tip = pointing(TO, frame);
    return tip.u === 0 && tip.v < 0;
  };
  if (tool.TYPE === "THREAD" && square(tool.TO)) return null;
  return issue(
    "toolUnfit",
    "error",
    { type: tool.TYPE, orientation: tool.TO, types: ["THREAD"], orientations: EVERY.filter(square) },
    "tool",
  );
}

/** The orientation whose tip points straight into the material. */
export const squareTo = (frame: Frame): TipOrientation =>
  frame.transverse ? (frame.signV > 0 ? 8 : 4) : frame.signV > 0 ? 2 : 6;

/** Where the tip of an orientation points, in strategy space. */
function pointing(TO: TipOrientation, frame: Frame): Flat {
  const tip = tipDirection(TO);
  return toFlat(frame, at(tip.u, tip.v));
}

/** Whether an orientation can stand over the material and cut in the direction of the strategy. */
function turnedRight(tool: Tool, frame: Frame): boolean {
  const tip = pointing(tool.TO, frame);
  if (tool.TYPE === "BUTTON") return tip.v <= 0 && !carriedInside(tool, frame);
  // A bar stands square over the surface; its tip is a corner or the middle of its edge.
  if (isBar(tool)) return pointing(axisOf(tool.TO), frame).v < 0;
  return tip.v <= 0 && tip.u >= 0 && !carriedInside(tool, frame);
}

/** The middle orientation of the three that a bar can have on one side. */
const axisOf = (TO: TipOrientation): TipOrientation => (TO === 1 || TO === 3 ? 2 : TO === 7 || TO === 5 ? 6 : TO);

/** The body of the insert lies on the side of the material. */
function carriedInside(tool: Tool, frame: Frame): boolean {
  const e = extent(insertIn(tool, frame));
  return -e.minV > e.maxV + 2 * noseRadius(tool) + SAME;
}

/**
 * Why a tool cannot do a machining at all, by its TYPE or its tip orientation, with the types and orientations that
 * can; null when it can. Source: tool table of the control (TYPE, TO), decision "Tools that fit".
 */
export function unfit(tool: Tool, frame: Frame, types: readonly ToolType[]): Issue | null {
  const type = types.some((each) => each === tool.TYPE);
  if (type && turnedRight(tool, frame)) return null;
  const shape = type ? tool : { ...tool, TYPE: types[0] ?? tool.TYPE };
  const orientations = EVERY.filter((TO) => TO !== 9 && turnedRight({ ...shape, TO }, frame));
  return issue("toolUnfit", "error", { type: tool.TYPE, orientation: tool.TO, types, orientations }, "tool");
}
