import type { Patch } from "../../view/material/pen.ts";

/** Lays a canvas over a part of its picture, in the pixels of the device. */
export function fitCanvas(element: HTMLCanvasElement, { x, y, width, height }: Patch): void {
  const [wide, tall] = [Math.round(width * devicePixelRatio), Math.round(height * devicePixelRatio)];
  if (element.width !== wide || element.height !== tall) {
    element.width = wide;
    element.height = tall;
    element.style.width = `${width}px`;
    element.style.height = `${height}px`;
  }
  element.style.left = `${x}px`;
  element.style.top = `${y}px`;
}
