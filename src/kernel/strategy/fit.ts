import type { Flat, Frame } from "../geometry/flat.ts";
import { toFlat } from "../geometry/flat.ts";
import { extent } from "../reach/convex.ts";
import { isBar, noseRadius, tipDirection } from "../cutter/insert.ts";
import { issue, type Issue } from "../plan/issue.ts";
import { at } from "../geometry/point.ts";
import { SAME } from "../tolerance.ts";
import type { TipOrientation, Tool, ToolType } from "../plan/tool.ts";
import { insertIn } from "./tip-envelope.ts";

const EVERY: readonly TipOrientation[] = [1, 2, 3, 4, 5, 6, 7, 8, 9];

/**
 * The issue of a tool that cannot cut a thread: another TYPE, or a tip that does not point straight into the material.
 */
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

/** Direction of the tip for an orientation, in strategy space. */
function pointing(TO: TipOrientation, frame: Frame): Flat {
  const tip = tipDirection(TO);
  return toFlat(frame, at(tip.u, tip.v));
}

/** Whether a tool's orientation can cut the material in the direction of the strategy. */
function fitsDirection(tool: Tool, frame: Frame): boolean {
  const tip = pointing(tool.TO, frame);
  if (tool.TYPE === "BUTTON") return tip.v <= 0 && !isBodyInMaterial(tool, frame);
  // A bar is square to the surface; its tip is a corner or the middle of its edge.
  if (isBar(tool)) return pointing(axisOf(tool.TO), frame).v < 0;
  return tip.v <= 0 && tip.u >= 0 && !isBodyInMaterial(tool, frame);
}

/** The middle one of the three orientations of a bar on one side. */
const axisOf = (TO: TipOrientation): TipOrientation => (TO === 1 || TO === 3 ? 2 : TO === 7 || TO === 5 ? 6 : TO);

/** True if the body of the insert is on the side of the material. */
function isBodyInMaterial(tool: Tool, frame: Frame): boolean {
  const e = extent(insertIn(tool, frame));
  return -e.minV > e.maxV + 2 * noseRadius(tool) + SAME;
}

/**
 * The issue of a tool that cannot do a machining operation because of its TYPE or tip orientation, with the suitable
 * types and orientations; null if it can. Source: tool table of the control (TYPE, TO), decision "Tools that fit".
 */
export function unfitIssue(tool: Tool, frame: Frame, types: readonly ToolType[]): Issue | null {
  const type = types.some((each) => each === tool.TYPE);
  if (type && fitsDirection(tool, frame)) return null;
  const shape = type ? tool : { ...tool, TYPE: types[0] ?? tool.TYPE };
  const orientations = EVERY.filter((TO) => TO !== 9 && fitsDirection({ ...shape, TO }, frame));
  return issue("toolUnfit", "error", { type: tool.TYPE, orientation: tool.TO, types, orientations }, "tool");
}
