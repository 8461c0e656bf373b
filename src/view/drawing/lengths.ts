import type { Place } from "../camera.ts";
import { mostThatFit, spread } from "../dimensions/spread.ts";
import {
  arrow,
  ARROW,
  dimensionLine,
  isCrossed,
  tallOf,
  LINE,
  widthOf,
  writtenAt,
  type Drawn,
  type PrintShape,
  type PrintSize,
  type PrintText,
} from "./paper.ts";
import { circleAt, lineThrough } from "../dimensions/strokes.ts";

/** A size along one direction: where its line begins on the part, mm on paper, and its rank: the least goes first. */
export interface PrintLength<P = Place> {
  readonly size: PrintSize;
  readonly from: P;
  readonly extent: number;
}

/** Up to this many lengths each have a line of their own; more share one line as running dimensions. */
const MOST_LINES = 4;
/** Gap between part and extension line; overshoot of an extension line past its dimension line; mm on paper. */
export const AIR = 0.8;
const PAST = 1.2,
  FIRST = 7;
const ORIGIN = 0.8;

export interface DrawnLengths extends Drawn {
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
  return onSheet.find(isClear) ?? onSheet[0] ?? Math.max(wide / 2, Math.min(middle, width - wide / 2));
}

/** Lengths from the zero edge; the shortest is nearest to the part. */
export function drawnLengths(lengths: readonly PrintLength[], room: LengthRoom): DrawnLengths {
  if (lengths.length === 0) return { shapes: [], texts: [], reach: 0, isCrossed: false, omitted: 0 };
  const {
    zero: { x: from },
  } = room;
  const sorted = [...lengths].sort((a, b) => Math.abs(a.from.x - from) - Math.abs(b.from.x - from));
  return sorted.length <= MOST_LINES && !room.middles ? inParallel(sorted, room) : addingUp(sorted, room);
}

const FIRST_LINE = { below: FIRST - 2, above: FIRST - LINE.stacked } as const;
const stepTo = ({ size }: Pick<PrintLength, "size">): number => tallOf(size) + 0.6;

/** How far lengths on lines of their own reach from the part, mm on paper. */
export const reachOfLines = (lengths: readonly Pick<PrintLength, "size">[], side: "below" | "above"): number =>
  lengths.length === 0
    ? 0
    : lengths.reduce((sum, each) => sum + stepTo(each), FIRST_LINE[side]) +
      (side === "below" ? 2 * PAST : LINE.stacked);

function inParallel(lengths: readonly PrintLength[], { zero, edge, side, width, clear }: LengthRoom): DrawnLengths {
  const shapes: PrintShape[] = [];
  const texts: PrintText[] = [];
  const down = side === "below" ? 1 : -1;
  let reach: number = FIRST_LINE[side];
  for (const [i, each] of lengths.entries()) {
    const { size, from } = each;
    reach += stepTo(each);
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
  return { shapes, texts, omitted: 0, isCrossed: crossed, reach: reachOfLines(lengths, side) };
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

/** A row of texts along an edge, each led to by a line from its place. Mm on paper. */
interface TextRow {
  /** Where the lines turn to their texts, and where the texts begin. */
  readonly turn: number;
  readonly foot: number;
  /** The side of the texts: 1 towards greater numbers. */
  readonly way: 1 | -1;
  readonly low: number;
  readonly high: number;
  /** Least gap between two texts. */
  readonly gap: number;
  /** A column beside the part instead of a row of turned texts; its lines begin with a dot. */
  readonly isColumn: boolean;
  /** Places of the texts in their order along the row, if they are known. */
  readonly middles?: readonly number[];
}

/** Nearer places cannot be told apart, mm on paper: a size without an extent is left out beside a better one. */
const APART = 0.35;
/** The end of a leader on a surface, mm on paper. */
const DOT = 0.45;

/**
 * As many sizes as have room in a row of texts, in the order of their places, so that no line crosses another. Those of
 * the least extent are left out first, of equal ones the last.
 */
export function rowOfTexts(
  asked: readonly PrintLength[],
  { turn, foot, way, low, high, gap, isColumn, middles }: TextRow,
): Drawn & { readonly shown: readonly PrintLength[] } {
  const along = ({ x, y }: Place) => (isColumn ? y : x),
    placeAt = (a: number, out: number): Place => (isColumn ? { x: out, y: a } : { x: a, y: out });
  const all = asked.filter(
    (own, i) =>
      own.extent > 0 ||
      !asked.some((other, k) => (other.extent > 0 || k < i) && Math.abs(along(other.from) - along(own.from)) < APART),
  );
  const laid =
    mostThatFit(
      all.toSorted((a, b) => b.extent - a.extent),
      (ranked) => {
        const some = ranked.toSorted((a, b) => along(a.from) - along(b.from)),
          wanted = some.map(({ from, size }) => ({ at: along(from), size: tallOf(size) }));
        const found = middles ?? spread(wanted, low, high, gap);
        return found && some.map((each, i) => ({ ...each, middle: found[i] ?? along(each.from) }));
      },
    ) ?? [];
  return {
    shapes: laid.flatMap(({ from, middle }): PrintShape[] => {
      const start = isColumn ? from : placeAt(along(from), from.y + way * AIR);
      return [
        { role: "thin", d: lineThrough([start, placeAt(along(from), turn), placeAt(middle, foot)]) },
        ...(isColumn ? [{ role: "arrow" as const, d: circleAt(from, DOT) }] : []),
      ];
    }),
    texts: laid.map(({ size, middle }) =>
      writtenAt(size, placeAt(middle, foot + way * (widthOf(size) / 2 + AIR)), !isColumn),
    ),
    omitted: all.length - laid.length,
    shown: laid,
  };
}

/** How far texts in a row reach from the part, beginning at their feet; mm on paper. */
export const reachOfTexts = (sizes: readonly Pick<PrintLength, "size">[], foot: number): number =>
  foot + Math.max(...sizes.map(({ size }) => widthOf(size))) + 2;

/** Lengths that share one dimension line, with turned texts behind it. */
function addingUp(lengths: readonly PrintLength[], { zero, edge, side, width, middles }: LengthRoom): DrawnLengths {
  const down = side === "below" ? 1 : -1,
    y = edge + down * FIRST,
    far = lengths.at(-1);
  const turned = rowOfTexts(lengths, {
    turn: y + down * PAST,
    foot: edge + down * TO_FEET,
    way: down,
    low: 1,
    high: width - 1,
    gap: 0.3,
    isColumn: false,
    ...(middles && { middles }),
  });
  const line = [zero, far?.from ?? zero].map(({ x }) => ({ x, y }));
  return {
    ...turned,
    shapes: [
      extension(zero, down, y),
      { role: "thin", d: lineThrough(line) },
      { role: "origin", d: circleAt({ x: zero.x, y }, ORIGIN) },
      ...turned.shapes,
      ...turned.shown.map(({ from: { x } }): PrintShape => ({ role: "arrow", d: arrow({ x, y }, x - zero.x, 0) })),
    ],
    isCrossed: false,
    reach: reachOfTexts(lengths, TO_FEET),
  };
}
