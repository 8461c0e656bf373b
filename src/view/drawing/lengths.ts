import type { Place } from "../camera.ts";
import { spread } from "../dimensions/spread.ts";
import {
  arrow,
  ARROW,
  dimensionLine,
  isCrossed,
  tallOf,
  LINE,
  widthOf,
  writtenAt,
  type PrintShape,
  type PrintSize,
  type PrintText,
} from "./paper.ts";
import { circleAt, lineThrough } from "../dimensions/strokes.ts";

/** A length from Z0: where its dimension begins on the part, mm on paper. */
export interface PrintLength {
  readonly size: PrintSize;
  readonly from: Place;
}

/** Up to this many lengths each have a line of their own; more share one line as running dimensions. */
const MOST_LINES = 4;
/** Gap between part and extension line; overshoot of an extension line past its dimension line; mm on paper. */
export const AIR = 0.8;
const PAST = 1.2,
  FIRST = 7;
const ORIGIN = 0.8;

export interface DrawnLengths {
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  /** How far they reach from the part, mm on paper. */
  readonly reach: number;
  /** A passing line crosses a text that has no other place. */
  readonly isCrossed: boolean;
}

/** The room for lengths: from an edge of the part, below or above it, on paper of a width. */
interface LengthRoom {
  readonly zero: Place;
  readonly edge: number;
  readonly side: "below" | "above";
  readonly width: number;
  /** Passing lines that texts avoid where possible. */
  readonly clear: readonly (readonly Place[])[];
  /**
   * Places of the turned texts, from the left, if all texts are turned; without it each is as near to its line as
   * possible.
   */
  readonly middles?: readonly number[];
}

/** Where lines cross a level. */
const through = (lines: readonly (readonly Place[])[], y: number): number[] =>
  lines.flatMap((line) =>
    line.slice(1).flatMap((b, i) => {
      const a = line[i] ?? b;
      return (a.y - y) * (b.y - y) > 0 || a.y === b.y ? [] : [a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)];
    }),
  );

/** Step of the search for a text's place, and its limit beside the line, mm on paper. */
const FINE = 0.5,
  FAR = 30;

/**
 * The middle of the text of a line between two places: the middle of the line, else the nearest point where no other
 * line crosses the text, else beside the line, behind its arrows; on paper of a width.
 */
function clearMiddle([a, b]: readonly [number, number], wide: number, stops: readonly number[], width: number): number {
  const middle = (a + b) / 2,
    free = (b - a - wide) / 2,
    out = 2 * ARROW.long + wide / 2;
  const steps = Array.from({ length: FAR / FINE }, (_, i) => i * FINE);
  const along = steps.filter((by) => by <= free).flatMap((by) => [middle + by, middle - by]);
  const beside = steps.flatMap((by) => [b + out + by, a - out - by]);
  const isClear = (x: number) => stops.every((stop) => Math.abs(stop - x) > wide / 2);
  // A text longer than its line goes beside it, over the end of the arrow.
  const places = wide > b - a - 2 * ARROW.long ? beside : [...along, ...beside];
  // Texts stay on the sheet, however short the line at its edge.
  const onSheet = places.filter((x) => x - wide / 2 >= 0 && x + wide / 2 <= width);
  return onSheet.find(isClear) ?? onSheet[0] ?? middle;
}

/** Lengths from the zero edge; the shortest is nearest to the part. */
export function drawnLengths(lengths: readonly PrintLength[], room: LengthRoom): DrawnLengths {
  if (lengths.length === 0) return { shapes: [], texts: [], reach: 0, isCrossed: false };
  const {
    zero: { x: from },
  } = room;
  const sorted = [...lengths].sort((a, b) => Math.abs(a.from.x - from) - Math.abs(b.from.x - from));
  return sorted.length <= MOST_LINES && !room.middles ? inParallel(sorted, room) : addingUp(sorted, room);
}

function inParallel(lengths: readonly PrintLength[], { zero, edge, side, width, clear }: LengthRoom): DrawnLengths {
  const shapes: PrintShape[] = [];
  const texts: PrintText[] = [];
  const down = side === "below" ? 1 : -1;
  let reach = side === "below" ? FIRST - 2 : FIRST - LINE.stacked;
  for (const [i, { size, from }] of lengths.entries()) {
    reach += tallOf(size) + 0.6;
    const y = edge + down * reach;
    const [a, b] = [
      { x: Math.min(from.x, zero.x), y },
      { x: Math.max(from.x, zero.x), y },
    ];
    shapes.push(...dimensionLine(a, b), extension(from, down, y));
    const wide = widthOf(size) + 1;
    // Passing lines, and the extension lines of lengths farther out.
    const stops = [
      ...[y - LINE.plain / 2, y, y - tallOf(size)].flatMap((level) => through(clear, level)),
      ...lengths.slice(i + 1).map((other) => other.from.x),
    ];
    const x = clearMiddle([a.x, b.x], wide, stops, width);
    const ends = [x - wide / 2, x + wide / 2] as const;
    if (ends[1] > b.x) shapes.push({ role: "thin", d: lineThrough([b, { x: ends[1], y }]) });
    else if (ends[0] < a.x) shapes.push({ role: "thin", d: lineThrough([a, { x: ends[0], y }]) });
    texts.push(writtenAt(size, { x, y: y - tallOf(size) / 2 }, false));
  }
  shapes.push(extension(zero, down, edge + down * reach));
  const crossed = texts.some(({ box }) => isCrossed(clear, box));
  return { shapes, texts, isCrossed: crossed, reach: reach + (side === "below" ? 2 * PAST : LINE.stacked) };
}

const extension = ({ x, y }: Place, down: number, end: number): PrintShape => ({
  role: "thin",
  d: lineThrough([
    { x, y: y + down * AIR },
    { x, y: end + down * PAST },
  ]),
});

/** From the part to the lower ends of turned texts, mm on paper. */
export const TO_FEET = FIRST + 5;

/** The turned texts of running dimensions, from the left; none if each length has its own line, unless forced. */
export const turnedTexts = (
  lengths: readonly PrintLength[],
  must: boolean,
): readonly { readonly at: number; readonly size: number }[] =>
  lengths.length <= MOST_LINES && !must
    ? []
    : fromLeft(lengths).map(({ size, from }) => ({ at: from.x, size: tallOf(size) }));

const fromLeft = (lengths: readonly PrintLength[]) => [...lengths].sort((a, b) => a.from.x - b.from.x);

function addingUp(
  lengths: readonly PrintLength[],
  { zero, edge, side, width, middles: given }: LengthRoom,
): DrawnLengths {
  const down = side === "below" ? 1 : -1,
    y = edge + down * FIRST,
    foot = edge + down * TO_FEET;
  const sorted = fromLeft(lengths),
    far = lengths.at(-1);
  const middles = given ?? spread(turnedTexts(lengths, true), 1, width - 1, 0.3);
  const long = Math.max(...lengths.map(({ size }) => widthOf(size)));
  const shapes: PrintShape[] = [
    extension(zero, down, y),
    {
      role: "thin",
      d: lineThrough([
        { x: zero.x, y },
        { x: far?.from.x ?? zero.x, y },
      ]),
    },
    {
      role: "origin",
      d: circleAt({ x: zero.x, y }, ORIGIN),
    },
  ];
  const texts = sorted.map(({ size, from }, i) => {
    const x = middles?.[i] ?? from.x;
    shapes.push({
      role: "thin",
      d: lineThrough([
        { x: from.x, y: from.y + down * AIR },
        { x: from.x, y: y + down * PAST },
        { x, y: foot },
      ]),
    });
    shapes.push({ role: "arrow", d: arrow({ x: from.x, y }, from.x - zero.x, 0) });
    return writtenAt(size, { x, y: foot + down * (widthOf(size) / 2 + 0.8) }, true);
  });
  return { shapes, texts, isCrossed: false, reach: TO_FEET + long + 2 };
}
