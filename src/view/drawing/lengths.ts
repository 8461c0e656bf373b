import type { Place } from "../camera.ts";
import { spread } from "../sheet/spread.ts";
import {
  arrow,
  ARROW,
  dimensionLine,
  isCrossed,
  tallOf,
  LINE,
  lineThrough,
  onPaperGrid,
  widthOf,
  writtenAt,
  type PrintShape,
  type PrintSize,
  type PrintText,
} from "./paper.ts";

/** A length from Z0: where its dimension begins on the part, mm on paper. */
export interface PrintLength {
  readonly size: PrintSize;
  readonly from: Place;
}

/** More than so many stand on one line, as they add up; fewer stand each on a line of its own. */
const MOST_LINES = 4;
/** Air between part and extension line; an extension line goes on past its dimension line; mm on paper. */
export const AIR = 0.8;
const PAST = 1.2,
  FIRST = 7;
const ORIGIN = 0.8;

export interface DrawnLengths {
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  /** How far they reach from the part, mm on paper. */
  readonly reach: number;
  /** A line that goes by crosses a text, which has no other place. */
  readonly isCrossed: boolean;
}

/** Where lengths stand: from an edge of the part, below it or above it, on paper of a width. */
interface LengthRoom {
  readonly zero: Place;
  readonly edge: number;
  readonly side: "below" | "above";
  readonly width: number;
  /** Lines that go by, from which texts keep clear where they can. */
  readonly clear: readonly (readonly Place[])[];
  /** Where turned texts stand, from the left, where all of them do; without it each as near to its line as it can. */
  readonly middles?: readonly number[];
}

/** Where lines go through a level. */
const through = (lines: readonly (readonly Place[])[], y: number): number[] =>
  lines.flatMap((line) =>
    line.slice(1).flatMap((b, i) => {
      const a = line[i] ?? b;
      return (a.y - y) * (b.y - y) > 0 || a.y === b.y ? [] : [a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)];
    }),
  );

/** How finely a place for a text is looked for, and how far beside its line, mm on paper. */
const FINE = 0.5,
  FAR = 30;

/**
 * The middle of a text for a line between two places: that of the line, or the nearest to it where no other line goes
 * through the text, or beside the line, behind its arrows; on paper of a width.
 */
function clearMiddle([a, b]: readonly [number, number], wide: number, stops: readonly number[], width: number): number {
  const middle = (a + b) / 2,
    free = (b - a - wide) / 2,
    out = 2 * ARROW.long + wide / 2;
  const steps = Array.from({ length: FAR / FINE }, (_, i) => i * FINE);
  const along = steps.filter((by) => by <= free).flatMap((by) => [middle + by, middle - by]);
  const beside = steps.flatMap((by) => [b + out + by, a - out - by]);
  const isClear = (x: number) => stops.every((stop) => Math.abs(stop - x) > wide / 2);
  // A text that is longer than its line stands beside it, over the end of the arrow.
  const places = wide > b - a - 2 * ARROW.long ? beside : [...along, ...beside];
  // The sheet ends where it ends, however short the line at its edge.
  const onSheet = places.filter((x) => x - wide / 2 >= 0 && x + wide / 2 <= width);
  return onSheet.find(isClear) ?? onSheet[0] ?? middle;
}

/** Lengths from the zero edge; the shortest stands nearest. */
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
    // Lines that go by, and the extension lines of those that stand farther out.
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

/** From the part to the feet of turned texts, mm on paper. */
export const TO_FEET = FIRST + 5;

/**
 * The turned texts that lengths have where they add up, from the left; none where each stands on a line of its own
 * unless they must.
 */
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
      d: `M${onPaperGrid(zero.x - ORIGIN)} ${onPaperGrid(y)}a${ORIGIN} ${ORIGIN} 0 1 1 ${ORIGIN + ORIGIN} 0a${ORIGIN} ${ORIGIN} 0 1 1 ${
        -ORIGIN - ORIGIN
      } 0Z`,
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
    shapes.push({ role: "arrow", d: arrow({ x: from.x, y }, Math.sign(from.x - zero.x), 0) });
    return writtenAt(size, { x, y: foot + down * (widthOf(size) / 2 + 0.8) }, true);
  });
  return { shapes, texts, isCrossed: false, reach: TO_FEET + long + 2 };
}
