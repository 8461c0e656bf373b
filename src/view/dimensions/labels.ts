import type { Place, Size } from "../camera.ts";

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
  return boxAbout(middle, { width, height });
}

/** Whether two boxes share any area. */
export const labelsOverlap = (a: LabelBox, b: LabelBox): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The box of a size about its middle. */
export const boxAbout = ({ x, y }: Place, { width, height }: Size): LabelBox => ({
  x: x - width / 2,
  y: y - height / 2,
  width,
  height,
});
export const middleOf = ({ x, y, width, height }: LabelBox): Place => ({ x: x + width / 2, y: y + height / 2 });

/** A straight line on the screen. */
export type StraightLine = readonly [from: Place, to: Place];

/** The area that two boxes share. */
export const sharedArea = (a: LabelBox, b: LabelBox): number =>
  Math.max(0, Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x)) *
  Math.max(0, Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y));

/** Whether a box is whole in a room. */
export const isWholeIn = (b: LabelBox, room: LabelBox): boolean =>
  b.x >= room.x && b.y >= room.y && b.x + b.width <= room.x + room.width && b.y + b.height <= room.y + room.height;

/** A box moved the shortest way to where it is whole in a room; one larger than the room keeps to its left and top. */
export function movedInto(b: LabelBox, room: LabelBox): LabelBox {
  const inside = (at: number, long: number, low: number, high: number) => Math.max(low, Math.min(at, high - long));
  return {
    ...b,
    x: inside(b.x, b.width, room.x, room.x + room.width),
    y: inside(b.y, b.height, room.y, room.y + room.height),
  };
}

/**
 * Whether a line from (ax, ay) to (bx, by) runs through a box of the same space; plain numbers, because a picture asks
 * for every piece of a contour in every frame.
 */
export function isThrough(ax: number, ay: number, bx: number, by: number, box: LabelBox): boolean {
  // The shares of the line at which it meets the four sides; a level or upright one meets two of them at infinity.
  const left = (box.x - ax) / (bx - ax),
    right = (box.x + box.width - ax) / (bx - ax),
    top = (box.y - ay) / (by - ay),
    floor = (box.y + box.height - ay) / (by - ay);
  const enters = Math.max(0, Math.min(left, right), Math.min(top, floor));
  return enters < Math.min(1, Math.max(left, right), Math.max(top, floor));
}

/** Whether a line runs through a box. */
export const runsThrough = ([a, b]: StraightLine, box: LabelBox): boolean => isThrough(a.x, a.y, b.x, b.y, box);

/** The box round a line. */
export const boxOfLine = ([a, b]: StraightLine): LabelBox => ({
  x: Math.min(a.x, b.x),
  y: Math.min(a.y, b.y),
  width: Math.abs(a.x - b.x),
  height: Math.abs(a.y - b.y),
});
