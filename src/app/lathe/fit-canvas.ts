import type { Size } from "../../view/camera.ts";
import type { Pen } from "../../view/material/pen.ts";

/** Gives a canvas the size of its picture in the pixels of the device; its pen counts in those of the page. */
export function fitCanvas(element: HTMLCanvasElement, pen: Pen, { width, height }: Size): void {
  const ratio = devicePixelRatio;
  const [wide, tall] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (element.width !== wide || element.height !== tall) {
    element.width = wide;
    element.height = tall;
    element.style.width = `${width}px`;
    element.style.height = `${height}px`;
  }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
}
