import type { Patch } from "../../../view/material/pen.ts";
import { pageLength } from "../../base/unit.ts";

/** Lays a canvas over a part of its picture. */
export function layOver({ style }: HTMLCanvasElement, { x, y, width, height }: Patch): void {
  style.left = pageLength(x);
  style.top = pageLength(y);
  style.width = pageLength(width);
  style.height = pageLength(height);
}

/** The same, with `ratio` pixels per unit of the page. */
export function fitCanvas(element: HTMLCanvasElement, part: Patch, ratio: number): void {
  const { width, height } = part;
  const [wide, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (element.width !== wide || element.height !== tall) {
    element.width = wide;
    element.height = tall;
  }
  layOver(element, part);
}
