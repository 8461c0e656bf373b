import { at, type Pt } from "../../kernel/geometry/point.ts";
import type { Place } from "../camera.ts";
import { lineThrough } from "../dimensions/strokes.ts";
import { AIR, rowOfTexts } from "./lengths.ts";
import {
  dimensionLine,
  halfDimensionLine,
  isCrossed,
  LINE,
  tallOf,
  widthOf,
  writtenAt,
  type Drawn,
  type PrintShape,
  type PrintText,
} from "./paper.ts";
import type { Across } from "./print-sizes.ts";

/** From the part to the first dimension, and from one to the next beside the part, mm on paper. */
const FIRST = 6,
  NEXT_TO = 1.6;
/** How far the line of a bore continues behind its text, mm on paper. */
const PAST_TEXT = 2;
/** From where a leader turns to its text, and least gap between two texts of a column, mm on paper. */
export const KNEE = 5,
  GAP = 0.5;
/** From the part to the texts of coordinates, mm on paper. */
export const TO_TEXTS = FIRST + KNEE;

/** How sizes are drawn: each with a dimension line, or as coordinates in rows of texts. */
export type SizeForm = "lines" | "coordinates";

/** Width of the diameters on one side of the part, mm on paper. */
export function widthOfColumn(list: readonly Across[], form: SizeForm): number {
  if (list.length === 0) return 0;
  const widest = Math.max(...list.map(({ size }) => widthOf(size)));
  return form === "coordinates"
    ? TO_TEXTS + AIR + widest
    : list.reduce((sum, { size }) => sum + tallOf(size) + NEXT_TO, FIRST);
}

/** Height that the diameters on one side need, mm on paper. */
export const heightOfColumn = (list: readonly Across[], form: SizeForm): number =>
  form === "coordinates" ? list.length * (LINE.plain + GAP) : Math.max(0, ...list.map(({ size }) => widthOf(size)));

/** The part on paper, mm: the level of its axis, and the end beside which diameters stand. */
interface ColumnRoom {
  readonly side: 1 | -1;
  readonly end: number;
  readonly axis: number;
  readonly low: number;
  readonly high: number;
  readonly onPaper: (p: Pt) => Place;
  /** Leaders from above, which texts avoid. */
  readonly clear: readonly (readonly Place[])[];
}

/** Draws the diameters of one side. */
export function drawnColumn(list: readonly Across[], form: SizeForm, room: ColumnRoom): Drawn {
  const { side, end, axis, low, high, onPaper, clear } = room;
  if (form === "coordinates")
    return rowOfTexts(
      // Of a bore the lower half shows more: the upper one carries the outside.
      list.map((a) => ({ ...a, from: onPaper(at(a.right, a.isBore ? -a.r : a.r)) })),
      {
        turn: end + side * FIRST,
        foot: end + side * TO_TEXTS,
        way: side,
        low,
        high,
        gap: GAP,
        isColumn: true,
      },
    );
  const shapes: PrintShape[] = [];
  const texts: PrintText[] = [];
  let x = end + side * (FIRST - NEXT_TO);
  for (const { size, r, left, right, isBore } of list) {
    // The text is on the left of its line, to be read from the right of the sheet.
    const tall = tallOf(size);
    const at0 = side > 0 ? x + tall + NEXT_TO : x - NEXT_TO;
    const z = side > 0 ? right : left,
      [upper, lower] = [onPaper(at(z, r)), onPaper(at(z, -r))];
    // The lower half shows the outside: the line of a bore ends behind the centre line, with one arrow.
    for (const { x: start, y } of isBore ? [upper] : [upper, lower])
      shapes.push({
        role: "thin",
        d: lineThrough([
          { x: start + side * AIR, y },
          { x: at0 + side * 1.2, y },
        ]),
      });
    const top = { x: at0, y: upper.y },
      text = (y: number) => writtenAt(size, { x: at0 - tall / 2 - 0.4, y }, true);
    // Leaders come from above: a text that one would cross moves down.
    const down = Array.from(
      { length: Math.max(1, Math.floor(lower.y - axis - widthOf(size) / 2)) },
      (_, by) => axis + by,
    );
    const middle = down.find((y) => !isCrossed(clear, text(y).box)) ?? axis;
    shapes.push(
      ...(isBore
        ? halfDimensionLine(top, { x: at0, y: middle + widthOf(size) / 2 + PAST_TEXT })
        : dimensionLine(top, { x: at0, y: lower.y })),
    );
    texts.push(text(middle));
    x = side > 0 ? at0 : at0 - tall;
  }
  return { shapes, texts, omitted: 0 };
}
