import { holderOutlines, shankAxis } from "../../kernel/cutter/holder.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { boundsOf } from "../bounds.ts";
import { toScreen, type Bounds, type Camera, type Place } from "../camera.ts";
import type { VisibleArea } from "../edge-mark.ts";

/**
 * Where a shank leaves the picture: the middle of the break, the direction in which the shank continues, and its width,
 * pixels.
 */
export interface Broken {
  readonly at: Place;
  /** Degrees clockwise from right. */
  readonly turn: 0 | 90 | 180 | 270;
  readonly width: number;
}

const shanks = new WeakMap<Tool, Bounds | null>();

/** The box round the shank of a tool, from its tip; null without a shank. Cached, because every picture needs it. */
function shankOf(tool: Tool): Bounds | null {
  const known = shanks.get(tool);
  if (known !== undefined) return known;
  const box = boundsOf(tool.holder ? (holderOutlines(tool).at(-1) ?? []) : []);
  shanks.set(tool, box);
  return box;
}

/**
 * Where the shank of a tool with its tip at a place leaves the visible area; null if the end of the shank is visible,
 * or nothing of it.
 */
export function breakOf(tool: Tool, tip: Pt, camera: Camera, seen: VisibleArea): Broken | null {
  const shank = shankOf(tool);
  if (!tool.holder || !shank) return null;
  const corner = (z: number, r: number) => toScreen(camera, { z: (tip.z + z) as Pt["z"], r: (tip.r + r) as Pt["r"] });
  const [a, b] = [corner(shank.left, shank.low), corner(shank.right, shank.high)];
  const [left, right, top, bottom] = [Math.min(a.x, b.x), Math.max(a.x, b.x), Math.min(a.y, b.y), Math.max(a.y, b.y)];
  if (shankAxis(tool.TO, tool.holder.axis) === "Z") {
    if (bottom < seen.top || top > seen.bottom) return null;
    const y = (top + bottom) / 2,
      width = bottom - top;
    if (left < seen.right && right > seen.right && left > seen.left)
      return { at: { x: seen.right, y }, turn: 0, width };
    return right > seen.left && left < seen.left && right < seen.right
      ? { at: { x: seen.left, y }, turn: 180, width }
      : null;
  }
  if (right < seen.left || left > seen.right) return null;
  const x = (left + right) / 2,
    width = right - left;
  if (top < seen.top && bottom > seen.top && bottom < seen.bottom) return { at: { x, y: seen.top }, turn: 270, width };
  return bottom > seen.bottom && top < seen.bottom && top > seen.top
    ? { at: { x, y: seen.bottom }, turn: 90, width }
    : null;
}

/** Half the height of the wave, and how far the cut reaches beyond the shank on each side, pixels. */
const [WAVE, OVER] = [4, 3];
const n = (v: number) => Math.round(v * 10) / 10;

/**
 * A break for a shank that continues to the right: the line, and `deep` pixels of background that hide what is behind
 * it.
 */
export function breakData(width: number, deep: number): { readonly line: string; readonly ground: string } {
  const half = n(width / 2 + OVER),
    line = `M0 ${-half}C${WAVE * 2} ${n(-half / 2)} ${-WAVE * 2} ${n(half / 2)} 0 ${half}`;
  return { line, ground: `${line}H${deep}V${-half}Z` };
}
