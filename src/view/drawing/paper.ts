import { boxAbout, runsThrough, textWidth, type LabelBox } from "../dimensions/labels.ts";
import { arrowAt, lineThrough } from "../dimensions/strokes.ts";
import type { Place } from "../camera.ts";

/** Size of the figures of a drawing, mm on paper. */
export const FIGURES = 3;

/** A size as a print writes it: the nominal, with deviations stacked behind it where they are not one ± value. */
export interface PrintSize {
  readonly text: string;
  readonly upper?: string;
  readonly lower?: string;
}

/** What a line or an area of a drawing stands for; its weight and dashes belong to whoever paints it. */
export type PrintRole =
  | "section"
  | "outline"
  | "edge"
  | "axis"
  | "thin"
  | "arrow"
  | "break"
  | "mark"
  | "origin"
  | "chuck"
  | "chuckEdge"
  | "blank"
  | "zero"
  | "zeroFilled"
  | "measured";

export interface PrintShape {
  readonly role: PrintRole;
  /** Path data, mm on paper. */
  readonly d: string;
}

/** A text by the middle of its box, mm on paper; a turned one reads from the right. */
export interface PrintText extends PrintSize {
  /** The size that is written: the list of a drawing has the same object. */
  readonly size: PrintSize;
  readonly at: Place;
  readonly turned: boolean;
  readonly box: LabelBox;
}

/** Part of a drawing: its lines and texts, and the number of sizes that found no room. */
export interface Drawn {
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  readonly omitted: number;
}

/** Size of deviations, as a share of the nominal's. */
export const SMALL = 0.72;
/** Gap between nominal and deviations, and how far these stand above and below its middle, mm on paper. */
export const NEXT = 0.6,
  STACKED = 1.25;
/** Heights of a line of text, alone and with stacked deviations, mm on paper. */
export const LINE = { plain: 4, stacked: 5.4 } as const;
export const ARROW = { long: 2.4, wide: 0.5 } as const;

export const isStacked = (size: PrintSize): boolean => size.upper !== undefined || size.lower !== undefined;
export const tallOf = (size: PrintSize): number => (isStacked(size) ? LINE.stacked : LINE.plain);
export const nominalWidth = (size: PrintSize): number => textWidth(size.text, FIGURES);

/** Length of a text along its line, mm on paper. */
export function widthOf(size: PrintSize): number {
  const behind = Math.max(textWidth(size.upper ?? "", FIGURES * SMALL), textWidth(size.lower ?? "", FIGURES * SMALL));
  return nominalWidth(size) + (behind > 0 ? NEXT + behind : 0);
}

/** An arrow whose tip points in a direction. */
export const arrow = (tip: Place, dx: number, dy: number): string =>
  arrowAt(tip, { x: dx, y: dy }, { long: ARROW.long, half: ARROW.wide });

/** Padding round the letters in the box of a text, mm on paper. */
const IN_BOX = 0.6;

/** Whether one of the lines goes through the letters of a text. */
export function isCrossed(lines: readonly (readonly Place[])[], { x, y, width, height }: LabelBox): boolean {
  const letters = { x: x + IN_BOX, y: y + IN_BOX, width: width - 2 * IN_BOX, height: height - 2 * IN_BOX };
  return lines.some((line) => line.slice(1).some((to, i) => runsThrough([line[i] ?? to, to], letters)));
}

/** A text at its place, with its box. */
export function writtenAt(size: PrintSize, at: Place, turned: boolean): PrintText {
  const [long, tall] = [widthOf(size) + 1, tallOf(size)];
  const box = boxAbout(at, turned ? { width: tall, height: long } : { width: long, height: tall });
  return { ...size, size, at, turned, box };
}

/**
 * A dimension line between two places with arrows, on a level (`across` false) or upright line. Where it is too short
 * for them, they point inwards from outside.
 */
export function dimensionLine(a: Place, b: Place): readonly PrintShape[] {
  const length = Math.hypot(b.x - a.x, b.y - a.y) || 1,
    [dx, dy] = [(b.x - a.x) / length, (b.y - a.y) / length];
  const isShort = length < 3 * ARROW.long;
  const beyond = (p: Place, by: number): Place => ({ x: p.x + dx * by, y: p.y + dy * by });
  const line = isShort ? [beyond(a, -2 * ARROW.long), beyond(b, 2 * ARROW.long)] : [a, b];
  const arrows = isShort ? arrow(a, dx, dy) + arrow(b, -dx, -dy) : arrow(a, -dx, -dy) + arrow(b, dx, dy);
  return [
    { role: "thin", d: lineThrough(line) },
    { role: "arrow", d: arrows },
  ];
}

/**
 * A dimension line whose other end is not shown: from its arrow to where it breaks off. Where it is too short the arrow
 * stands outside.
 */
export function halfDimensionLine(tip: Place, end: Place): readonly PrintShape[] {
  const way = Math.sign(end.y - tip.y) || 1,
    isShort = Math.abs(end.y - tip.y) < 2 * ARROW.long;
  const start = isShort ? { x: tip.x, y: tip.y - way * 2 * ARROW.long } : tip;
  return [
    { role: "thin", d: lineThrough([start, end]) },
    { role: "arrow", d: arrow(tip, 0, isShort ? way : -way) },
  ];
}
