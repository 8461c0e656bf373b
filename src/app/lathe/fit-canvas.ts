import type { Patch, Pen } from "../../view/material/pen.ts";

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

/** The pen of a canvas that lies over a part of its picture counts in pixels of the page, from the corner of the picture. */
export const aimPen = (pen: Pen, { x, y }: Patch): void =>
  pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, -x * devicePixelRatio, -y * devicePixelRatio);
