import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Bounds, Place } from "../camera.ts";
import type { DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { lineThrough } from "../dimensions/strokes.ts";
import { bodyShapes, mirroredAt, type BodyView } from "./body.ts";
import { drawnColumn, GAP, heightOfColumn, KNEE, TO_TEXTS, widthOfColumn, type SizeForm } from "./columns.ts";
import { drawnLeaders, leaderRows, ROW, type Leader } from "./leaders.ts";
import {
  drawnLengths,
  reachOfLines,
  reachOfTexts,
  rowOfTexts,
  TO_FEET,
  turnedTexts,
  type PrintLength,
} from "./lengths.ts";
import { measuredOnPaper } from "./measured.ts";
import { type PrintShape, type PrintText } from "./paper.ts";
import type { Across, ListedSize, Note } from "./print-sizes.ts";
import { DRAWING_SCALES, factorOf, fillingScale, usualScale, type DrawingScale } from "./scales.ts";

/** A drawing of a part, all places in mm on paper from its top left corner. */
export interface PartDrawing {
  readonly scale: DrawingScale;
  readonly width: number;
  readonly height: number;
  /** From back to front. */
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  readonly list: readonly ListedSize[];
  /** The mark of all turned surfaces, as text; null if they have no common one. */
  readonly general: string | null;
  /** Number of sizes without room: a list beside the drawing has them. */
  readonly omitted: number;
  /** The place of Z0 on the axis, mm on paper: part space is scaled from here. */
  readonly origin: Place;
}

/** Part space on paper; scale: mm on paper for one of the part. */
export interface PaperScene {
  readonly onPaper: (p: Pt) => Place;
  readonly scale: number;
}

type Length = PrintLength<Pt>;

/** What a drawing shows to its audience. Part space, mm. */
export interface DrawnContent {
  readonly body: readonly Ring[];
  readonly view: Omit<BodyView, "onPaper" | "scale">;
  /** All that is drawn of the work, both halves. */
  readonly bounds: Bounds;
  readonly form: SizeForm;
  /** Shapes behind the part, over it, and over all lines. */
  readonly behind?: (scene: PaperScene) => readonly PrintShape[];
  readonly around?: (scene: PaperScene) => readonly PrintShape[];
  readonly front?: (scene: PaperScene) => readonly PrintShape[];
  /** The diameters beside the part, and those that become notes, at a scale. */
  readonly across: (scale: number) => {
    readonly right: readonly Across[];
    readonly left: readonly Across[];
    readonly noted: readonly Across[];
  };
  readonly below: readonly Length[];
  readonly above: readonly Length[];
  /** Where the lengths on either side begin. */
  readonly zero: { readonly below: Pt; readonly above: Pt };
  readonly measured?: readonly DimensionRequest[];
  readonly notes?: readonly Note[];
  readonly list?: readonly ListedSize[];
  /** The mark of all turned surfaces, as text. */
  readonly general?: string | null;
}

/**
 * Free edge of the paper; least width of the part: a drawing of many diameters grows wider than its room to keep it; how
 * much nearer to the work the lengths above it are than usual; mm on paper.
 */
const PAPER = {
  lines: { edge: 3, least: 72, nearer: 0 },
  coordinates: { edge: 1, least: 0, nearer: 3 },
} as const;
/** How far a leader is above the part, and how far the centre line extends past it, mm on paper. */
const ABOVE = 6,
  AXIS_PAST = 4;
/** Height for the notes and lengths of most drawings: few need all rows, mm on paper. */
const USUAL = 2 * ROW + ABOVE + 26;

/** Paper for a drawing, mm; the scale is the largest usual one for it where none is given. */
export interface PaperRoom {
  readonly width: number;
  readonly height: number;
  readonly scale?: DrawingScale;
  /** Whether the part fills the room, at any scale. */
  readonly fills?: boolean;
}

/** Extra height of the first try: few parts need all rows of notes and lengths. */
const HOPED = 40;

/** A drawing for a sheet of fixed size: at the largest usual scale at which everything fits. Sizes in mm on paper. */
export function drawingOnSheet(content: DrawnContent | null, { width, height }: PaperRoom): PartDrawing | null {
  const first = partDrawing(content, { width, height: height + HOPED });
  const smaller = DRAWING_SCALES.filter((scale) => first && factorOf(scale) < factorOf(first.scale));
  let print = first;
  for (const scale of smaller) {
    if (!print || (print.height <= height && print.width <= width)) return print;
    print = partDrawing(content, { width, height, scale });
  }
  return print;
}

/**
 * What an audience is shown of a part, for a width and a greatest height, mm on paper: the part along its axis,
 * diameters beside it, lengths below and above, notes with leaders on top. Null without content.
 */
export function partDrawing(content: DrawnContent | null, room: PaperRoom): PartDrawing | null {
  if (!content) return null;
  const plain = laidOut(content, room, false);
  // Lengths of a bore that leaders cross are turned upright between them.
  return plain.isCrossed ? laidOut(content, room, true).drawing : plain.drawing;
}

/** The same, with the lengths of features hidden from outside on lines of their own, or upright. */
function laidOut(
  content: DrawnContent,
  room: PaperRoom,
  upright: boolean,
): { readonly drawing: PartDrawing; readonly isCrossed: boolean } {
  const { bounds, form, measured = [], list = [], general = null } = content,
    { edge, least, nearer } = PAPER[form],
    isRow = form === "coordinates";
  const [wide, tall] = [bounds.right - bounds.left, 2 * bounds.high];
  const over = Math.max(0, reachOfLines(content.above, "above") - nearer);
  const kept = isRow ? edge + over + reachOfTexts(content.below, KNEE) + edge : USUAL;
  const scaled = (factor: number) => {
    const { right, left, noted } = content.across(factor);
    const besides = [left, right].map((list) => edge + Math.max(edge, widthOfColumn(list, form))),
      [before = 0, behind = 0] = besides;
    const width = Math.max(room.width, before + behind + least);
    const free = { wide: width - before - behind, tall: room.height - kept };
    const scale = room.scale ?? (room.fills ? fillingScale : usualScale)({ wide, tall }, free);
    return { right, left, noted, before, behind, width, free, scale };
  };
  const { right, left, noted, before, behind, width, free, scale } = scaled(factorOf(scaled(Infinity).scale));
  const k = factorOf(scale),
    x0 = before + Math.max(0, (free.wide - wide * k) / 2) - bounds.left * k;
  const needed = Math.max(...[right, left].map((list) => heightOfColumn(list, form)));
  const half = Math.max(bounds.high * k, (isRow ? Math.min(free.tall, needed - over) : needed) / 2);
  const inScene =
    (axis: number) =>
    (p: Pt): Place => ({ x: x0 + p.z * k, y: axis - p.r * k });
  const lengthsOnPaper = (list: readonly Length[], axis: number): PrintLength[] =>
    list.map(({ size, from, extent }) => ({ size, extent, from: inScene(axis)(from) }));
  const notes = [
    ...noted.map((a) => ({ size: a.size, at: at((a.left + a.right) / 2, a.r), isMark: false })),
    ...(content.notes ?? []),
  ].map(({ size, at: p, isMark }): Leader => ({ size, isMark, to: inScene(0)(p) }));
  const { rows, count, middles } = leaderRows(notes, width, turnedTexts(lengthsOnPaper(content.above, 0), upright));
  const lengthsAbove = (axis: number, clear: readonly (readonly Place[])[]) =>
    drawnLengths(lengthsOnPaper(content.above, axis), {
      zero: inScene(axis)(content.zero.above),
      edge: axis - half + nearer,
      side: "above",
      width: isRow ? x0 + bounds.right * k + TO_TEXTS : width,
      clear,
      ...(middles.length > 0 && { middles }),
    });
  const above = Math.max(0, lengthsAbove(0, []).reach - nearer);
  const shelf = edge + Math.max(0, count - 1) * ROW + 6,
    axis = (count > 0 ? shelf + ABOVE : edge) + above + half;
  const onPaper = inScene(axis),
    scene: PaperScene = { onPaper, scale: k };
  const leaders = drawnLeaders(
    rows.map((row) => ({ ...row, leader: { ...row.leader, to: { ...row.leader.to, y: row.leader.to.y + axis } } })),
    shelf,
    [axis - half - above, axis - half - TO_FEET],
  );
  const ends = [onPaper(at(bounds.left, 0)), onPaper(at(bounds.right, 0))] as const;
  const columns = (
    [
      [right, 1, ends[1].x],
      [left, -1, ends[0].x],
    ] as const
  ).map(([list, side, end]) =>
    drawnColumn(list, form, { side, end, axis, onPaper, clear: leaders.lines, low: edge, high: axis + half }),
  );
  const floor = axis + half,
    lower = (list: readonly Length[]) => list.map((each) => ({ ...each, from: onPaper(mirroredAt(each.from)) }));
  const row = {
    turn: floor,
    foot: floor + KNEE,
    way: 1,
    low: 1,
    high: width - behind,
    gap: GAP,
    isColumn: false,
  } as const;
  const drawnBelow = isRow
    ? { ...rowOfTexts(lower(content.below), row), reach: reachOfTexts(content.below, KNEE) }
    : drawnLengths(lower(content.below), {
        zero: onPaper(mirroredAt(content.zero.below)),
        edge: floor,
        side: "below",
        width,
        clear: [],
      });
  const drawnAbove = lengthsAbove(axis, leaders.lines),
    size = { width, height: floor + drawnBelow.reach + edge };
  const parts = [...columns, { ...leaders, omitted: notes.length - rows.length }, drawnBelow, drawnAbove];
  const camera = { scale: k, zero: onPaper(at(0, 0)), xUp: true },
    inspected = measuredOnPaper(
      measured,
      camera,
      size,
      parts.flatMap(({ texts }) => texts.map(({ box }) => box)),
    );
  const drawing: PartDrawing = {
    ...size,
    scale,
    shapes: [
      ...(content.behind?.(scene) ?? []),
      ...bodyShapes(content.body, { ...content.view, ...scene }),
      ...(content.around?.(scene) ?? []),
      {
        role: "axis" as const,
        d: lineThrough([
          { x: Math.max(0, ends[0].x - AXIS_PAST), y: axis },
          { x: ends[1].x + AXIS_PAST, y: axis },
        ]),
      },
      ...parts.flatMap(({ shapes }) => shapes),
      ...(content.front?.(scene) ?? []),
      ...inspected.shapes,
    ].filter(({ d }) => d !== ""),
    texts: [...parts, inspected].flatMap(({ texts }) => texts),
    list,
    general,
    omitted: [...parts, inspected].reduce((sum, { omitted }) => sum + omitted, 0),
    origin: camera.zero,
  };
  return { drawing, isCrossed: drawnAbove.isCrossed };
}
