import type { Patch } from "../../../view/material/pen.ts";

/** Lays a canvas over a part of its picture. */
export function layOver({ style }: HTMLCanvasElement, { x, y, width, height }: Patch): void {
  style.left = `${x}px`;
  style.top = `${y}px`;
  style.width = `${width}px`;
  style.height = `${height}px`;
}

/** The same, with `ratio` pixels per CSS pixel. */
export function fitCanvas(element: HTMLCanvasElement, part: Patch, ratio: number): void {
  const { width, height } = part;
  const [wide, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (element.width !== wide || element.height !== tall) {
    element.width = wide;
    element.height = tall;
  }
  layOver(element, part);
}
