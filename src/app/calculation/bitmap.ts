import type { PaintedLook, Painter } from "../../view/material/painter.ts";
import type { Patch } from "../../view/material/pen.ts";

/** Width and height of a part of a picture, device pixels. `ratio`: of those per unit of the page. */
export const sized = ({ width, height }: Patch, ratio: number) =>
  [Math.round(width * ratio), Math.round(height * ratio)] as const;

/** Paints a part of a picture on its own canvas. */
export function painted(
  part: Patch,
  ratio: number,
  paint: (pen: OffscreenCanvasRenderingContext2D) => void,
): ImageBitmap {
  const canvas = new OffscreenCanvas(...sized(part, ratio)),
    pen = canvas.getContext("2d");
  if (pen) paint(pen);
  return canvas.transferToImageBitmap();
}

/** Paints what is around a stock; null for a look without it. */
export const groundPicture = <Look extends PaintedLook>(painter: Painter<Look>, look: Look): ImageBitmap | null =>
  look.ground && painted(look.ground, look.ratio, (pen) => painter.around(pen, look));
