import type { Place } from "../camera.ts";

/** A box on the screen, pixels. */
export interface LabelBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Text sizes, pixels: grey and active. Boxes use the larger one, so that nothing moves when a text becomes active. */
export const SIZE = { quiet: 12, strong: 14, caption: 12 } as const;

/** Width of a text in the figures' font (every letter 0.6 of its size; signs from other fonts a whole). */
export const textWidth = (text: string, size: number): number =>
  [...text].reduce((sum, c) => sum + (c.codePointAt(0)! > 0x2100 && c !== "−" && c !== "≤" ? 1 : 0.6), 0) * size;

/** The box of a text about its middle, with a pixel of air. */
export function textBox(middle: Place, text: string, turn: 0 | -90, size: number = SIZE.strong): LabelBox {
  const long = textWidth(text, size) + 4,
    tall = size + 2;
  const [width, height] = turn === 0 ? [long, tall] : [tall, long];
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
}

/** Whether two boxes share any area. */
export const labelsOverlap = (a: LabelBox, b: LabelBox): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The box round two places, a pixel thick at least. */
export const lineBox = (a: Place, b: Place): LabelBox => ({
  x: Math.min(a.x, b.x) - 0.5,
  y: Math.min(a.y, b.y) - 0.5,
  width: Math.abs(a.x - b.x) + 1,
  height: Math.abs(a.y - b.y) + 1,
});
