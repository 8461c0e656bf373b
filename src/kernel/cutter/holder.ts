import { hullOf, type Corner } from "./hull.ts";
import { correctionShift, TIP } from "./insert.ts";
import { at, type Ring } from "../geometry/point.ts";
import type { Holder, HolderCorner, TipOrientation, Tool } from "../plan/tool.ts";
import { length } from "../units.ts";

/** The axis of the shank: as stated for the holder, else as usual for tools of this orientation. */
export const shankAxis = (to: TipOrientation, axis?: "X" | "Z"): "X" | "Z" => axis ?? (to <= 3 || to === 9 ? "X" : "Z");

/**
 * The shank as a box, on the side opposite to the tip. Along Z it leaves the workpiece towards +Z, unless the tip
 * points there; along X it leaves the axis, unless the tip points away from it.
 */
function shank(h: Holder, to: TipOrientation): readonly Corner[] {
  const tip = TIP[to] ?? TIP[9];
  const along = shankAxis(to, h.axis) === "Z";
  const z = h.offsetZ + (tip.u > 0 ? -1 : 1) * (along ? h.length : h.width);
  const x = h.offsetX + (tip.v > 0 ? -1 : 1) * (along ? h.width : h.length);
  return [
    [h.offsetZ, h.offsetX],
    [z, h.offsetX],
    [z, x],
    [h.offsetZ, x],
  ];
}

/**
 * The holder as convex outlines (counter-clockwise) relative to the theoretical tip, the shank last; empty when the
 * tool has no holder. A correction moves it with the insert.
 */
export function holderOutlines(t: Tool): readonly Ring[] {
  if (!t.holder) return [];
  const shift = correctionShift(t);
  return [...(t.holder.head ?? []), shank(t.holder, t.TO)]
    .map((part) => hullOf(part).map(([z, x]) => at(z + shift.u, x + shift.v)))
    .filter((ring) => ring.length > 2);
}

const MIRRORED: Record<"r" | "z", Record<TipOrientation, TipOrientation>> = {
  r: { 1: 7, 2: 6, 3: 5, 4: 4, 5: 3, 6: 2, 7: 1, 8: 8, 9: 9 },
  z: { 1: 3, 2: 2, 3: 1, 4: 8, 5: 7, 6: 6, 7: 5, 8: 4, 9: 9 },
};

/**
 * Moves the near corner of the mirrored shank: a box whose tip points square to the mirrored axis extends to one side
 * only.
 */
function mirroredHolder(h: Holder, to: TipOrientation, axis: "r" | "z"): Holder {
  const flip = ([z, x]: HolderCorner): HolderCorner => (axis === "z" ? [length(-z), x] : [z, length(-x)]);
  const lies = shankAxis(to, h.axis);
  const tip = TIP[to] ?? TIP[9];
  const sideways = axis === "z" ? tip.u === 0 : tip.v === 0;
  const size = (axis === "z") === (lies === "Z") ? h.length : h.width;
  const back = sideways ? size : 0;
  return {
    ...h,
    axis: lies,
    offsetZ: axis === "z" ? length(-h.offsetZ - back) : h.offsetZ,
    offsetX: axis === "r" ? length(-h.offsetX - back) : h.offsetX,
    ...(h.head && { head: h.head.map((part) => part.map(flip)) }),
  };
}

/**
 * A tool with its tip and its holder mirrored along an axis, for a cycle that runs its contour in the other direction.
 */
export const mirroredTool = (tool: Tool, axis: "r" | "z"): Tool => ({
  ...tool,
  TO: MIRRORED[axis][tool.TO],
  ...(tool.holder && { holder: mirroredHolder(tool.holder, tool.TO, axis) }),
});
