import { boxAround } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { toDiameter } from "../../kernel/units.ts";
import type { Place } from "../camera.ts";
import { DRAWING_SCALES, factorOf, fillingScale, usualScale, type DrawingScale } from "../sheet/scales.ts";
import { BESIDE, bodyShapes, isHollow, isOutmost, spanAt } from "./body.ts";
import { AIR, drawnLengths, TO_FEET, turnedTexts, type PrintLength } from "./lengths.ts";
import { drawnLeaders, leaderRows, ROW, type Leader } from "./leaders.ts";
import {
  dimensionLine,
  halfDimensionLine,
  isCrossed,
  tallOf,
  widthOf,
  writtenAt,
  type PrintShape,
  type PrintSize,
  type PrintText,
} from "./paper.ts";
import { lineThrough } from "../dimensions/strokes.ts";
import type { MeasuredFeature } from "./measured-feature.ts";
import { printFeatures } from "./print-features.ts";
import {
  cornersOf,
  diametersOf,
  surfaceMarks,
  positionsOf,
  type Across,
  type PrintedPart,
  type PrintWords,
} from "./print-sizes.ts";

/** A size of the drawing as data, for a list beside it. */
export interface ListedSize {
  readonly kind: "diameter" | "bore" | "length" | "chamfer" | "radius" | "angle" | "thread" | "mark" | "blank";
  readonly size: PrintSize;
  /** Z of its place, both ends of a stretch; mm. */
  readonly at: readonly number[];
  /** What it measures on the part; null for the blank, threads and surface marks. */
  readonly measures: MeasuredFeature | null;
}

/** A workshop drawing, all places in mm on paper from its top left corner. */
export interface WorkshopPrint {
  readonly scale: DrawingScale;
  readonly width: number;
  readonly height: number;
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  readonly list: readonly ListedSize[];
  /** The mark of all turned surfaces, as text; null if they have no common one. */
  readonly general: string | null;
  /** Number of notes without room: the list has them. */
  readonly omitted: number;
  /** The place of Z0 on the axis, mm on paper: part space is scaled from here. */
  readonly origin: Place;
}

/** Nearer values are one, mm. */
const ONE = 0.005;
/** The stub of the blank drawn behind the part, as a share of the part's length, and its minimum, mm. */
const STUB = { share: 0.14, least: 4 } as const;
/** Edges of the paper; from the part to the first dimension, and from one to the next beside the part, mm on paper. */
const EDGE = 3,
  FIRST = 6,
  NEXT_TO = 1.6;
/** Least width of the part itself: a drawing of many diameters grows wider than its room to keep it, mm on paper. */
const LEAST = 72;
/** How far the line of a bore continues behind its text, mm on paper. */
const PAST_TEXT = 2;
/** How far a leader is above the part, and how far the centre line extends past it, mm on paper. */
const ABOVE = 6,
  AXIS_PAST = 4;

/** Whether a level line at a radius from `z` to `end` stays clear of material, outside of the part or in its bore. */
function isFree(rings: readonly Ring[], r: number, z: number, end: number, isBore: boolean): boolean {
  const stops = [z, end, ...rings.flat().map((p) => p.z)]
    .filter((v) => v >= Math.min(z, end) && v <= Math.max(z, end))
    .sort((a, b) => a - b);
  return stops.every((stop, i) => {
    const next = stops[i + 1];
    if (next === undefined || next - stop < ONE) return true;
    const span = spanAt(rings, (stop + next) / 2);
    return !span || (isBore ? span.low >= r - ONE : span.high <= r + ONE);
  });
}

/** Start of the drawn part of the blank: a stub behind the turned part, if the blank is longer. */
function shownFrom(work: PrintedPart): number {
  const box = boxAround([...work.blank]);
  const turned = [...work.outside, ...work.bore].flatMap((s) => [s.from.z, s.to.z]);
  if (turned.length === 0) return box.left;
  const end = Math.min(...turned),
    front = Math.max(...turned);
  const stub = end - Math.max(STUB.least, STUB.share * (front - end));
  return box.left < stub - STUB.least ? stub : box.left;
}

/** Paper for a drawing, mm; the scale is the largest usual one for it where none is given. */
export interface PrintRoom {
  readonly width: number;
  readonly height: number;
  readonly scale?: DrawingScale;
  /** Whether the part fills the room, at any scale. */
  readonly fills?: boolean;
}

/** Extra height of the first try: few parts need all rows of notes and lengths. */
const HOPED = 40;

/** The same for a sheet of fixed size: at the largest usual scale at which everything fits. Sizes in mm on paper. */
export function drawingOnSheet(
  work: PrintedPart,
  words: PrintWords,
  { width, height }: PrintRoom,
): WorkshopPrint | null {
  const first = workshopDrawing(work, words, { width, height: height + HOPED });
  const smaller = DRAWING_SCALES.filter((scale) => first && factorOf(scale) < factorOf(first.scale));
  let print = first;
  for (const scale of smaller) {
    if (!print || (print.height <= height && print.width <= width)) return print;
    print = workshopDrawing(work, words, { width, height, scale });
  }
  return print;
}

/**
 * The target part of a task as a workshop drawing, for a width and a greatest height, mm on paper: above the axis in
 * section if it is hollow, below it from outside; diameters beside it, lengths from Z0 below, notes with leaders above.
 * Null without a part.
 */
export function workshopDrawing(work: PrintedPart, words: PrintWords, room: PrintRoom): WorkshopPrint | null {
  if (work.rings.length === 0) return null;
  const plain = laidOut(work, words, room, false);
  // Lengths of a bore that leaders cross are turned upright between them.
  return plain.isCrossed ? laidOut(work, words, room, true).print : plain.print;
}

/** The same, with the lengths of features hidden from outside on lines of their own, or upright. */
function laidOut(
  work: PrintedPart,
  words: PrintWords,
  room: PrintRoom,
  upright: boolean,
): { readonly print: WorkshopPrint; readonly isCrossed: boolean } {
  const whole = boxAround([...work.rings]),
    from = shownFrom(work);
  const broken = from > whole.left + ONE ? from : null;
  const frame: Ring = [
    at(from, -1),
    at(whole.right + 1, -1),
    at(whole.right + 1, whole.high + 1),
    at(from, whole.high + 1),
  ];
  const body = broken === null ? work.rings : intersection(work.rings, [frame]);
  const box = boxAround([...body]);
  const outer = printFeatures(work.outside),
    inner = printFeatures(work.bore);
  const blank = boxAround([...work.blank]);
  const ends = work.outside.flatMap((each) => [each.from.z, each.to.z]),
    endsInside = work.bore.flatMap((each) => [each.from.z, each.to.z]);
  const ofBlank = (r: number, until: readonly number[], isBore: boolean): Across[] => {
    const right = Math.min(...until, blank.right);
    const size = { text: `(${words.diameter(toDiameter(at(0, r).r))})` };
    return r > ONE && right > box.left + ONE
      ? [{ r, left: box.left, right, isBore, isBlank: true, size, limits: [r, r] }]
      : [];
  };
  const blankSize = [...ofBlank(blank.high, ends, false), ...ofBlank(blank.low, endsInside, true)];
  const turned = [...diametersOf(work, outer, false, words), ...diametersOf(work, inner, true, words)];
  const across = [
    ...turned,
    ...blankSize.filter(({ r, isBore }) => !turned.some((t) => t.isBore === isBore && Math.abs(t.r - r) < ONE)),
  ];
  const threads = work.threads.map((thread) => ({ thread, size: { text: thread.name } }));
  const onThread = ({ r, left, right }: Across) =>
    work.threads.some(
      (t) => Math.abs(t.from.r - r) < ONE && [t.from.z, t.to.z].some((z) => z > left - ONE && z < right + 1),
    );

  const sideOf = (a: Across): "right" | "left" | "above" => {
    if (isFree(body, a.r, a.right, box.right, a.isBore)) return "right";
    return isFree(body, a.r, a.left, box.left, a.isBore) && (broken === null || !a.isBore) ? "left" : "above";
  };
  const shown = across.filter((a) => !onThread(a));
  // A text longer than its diameter would cross its own lines: it becomes a note.
  const isShort = ({ r, size }: Across, factor: number) => r * factor < widthOf(size) / 2 + AIR;
  const besides = (list: readonly Across[]) =>
    list.reduce((sum, { size }) => sum + tallOf(size) + NEXT_TO, list.length > 0 ? FIRST : EDGE) + EDGE;

  const highest = Math.max(...body.flat().map((p) => p.r));
  const scaled = (factor: number) => {
    const columns = (side: "right" | "left") =>
      shown.filter((a) => !isShort(a, factor) && sideOf(a) === side).sort((a, b) => a.r - b.r);
    const [right, left] = [columns("right"), columns("left")];
    const width = Math.max(room.width, besides(right) + besides(left) + LEAST);
    const roomed = { wide: width - besides(right) - besides(left), tall: room.height - 2 * ROW - ABOVE - 26 };
    return {
      right,
      left,
      width,
      roomed,
      scale:
        room.scale ??
        (room.fills ? fillingScale : usualScale)({ wide: box.right - box.left, tall: highest + highest }, roomed),
    };
  };
  const { right, left, width, roomed, scale } = scaled(factorOf(scaled(Infinity).scale));
  const positions = positionsOf(work, [outer, inner], words, broken === null ? box.left : null);
  const k = factorOf(scale);
  const x0 = besides(left) + Math.max(0, (roomed.wide - (box.right - box.left) * k) / 2) - box.left * k;
  const notes: Leader[] = [];
  const place = (p: Pt): Place => ({ x: x0 + p.z * k, y: -p.r * k });
  const listed: ListedSize[] = [];
  const addNote = (size: PrintSize, p: Pt, isMark = false) => notes.push({ size, to: place(p), isMark });
  for (const a of shown.filter((each) => !right.includes(each) && !left.includes(each)))
    addNote(a.size, at((a.left + a.right) / 2, a.r));
  for (const { thread, size } of threads) addNote(size, part.pointOn(part.line(thread.from, thread.to), 1 / 2));
  const corners = [...cornersOf(outer.corners, words), ...cornersOf(inner.corners, words)];
  for (const { corner, size } of corners) addNote(size, corner.at);
  const marks = surfaceMarks(work, outer, inner);
  for (const { at: p, most } of marks.single) addNote({ text: words.roughness(most) }, p, true);

  for (const { size, r, limits, isBore, isBlank, left: a, right: b } of across) {
    const kind = isBore ? "bore" : "diameter";
    listed.push({
      kind: isBlank ? "blank" : kind,
      size,
      at: a === b ? [a] : [b, a],
      measures: isBlank ? null : { kind: "diameter", r, left: a, right: b, limits },
    });
  }
  for (const { thread, size } of threads)
    listed.push({ kind: "thread", size, at: [thread.from.z, thread.to.z], measures: null });
  for (const { size, from: p, limits } of positions)
    listed.push({ kind: "length", size, at: [p.z], measures: { kind: "length", z: p.z, limits } });
  for (const { corner, size, all } of corners)
    listed.push({
      kind: corner.kind,
      size,
      at: all.map(({ z }) => z),
      measures:
        corner.kind === "angle"
          ? { kind: "angle", degrees: corner.size, places: all }
          : { kind: "corner", size: corner.size, places: all },
    });
  for (const { most, stretch } of marks.single)
    listed.push({ kind: "mark", size: { text: words.roughness(most) }, at: stretch, measures: null });

  const half = Math.max(highest * k, ...[...right, ...left].map(({ size }) => widthOf(size) / 2));
  // Features hidden from outside get their lengths above, in the section.
  const breaks = [0, ...outer.corners.map(({ size }) => size)];
  // At a broken corner the edge itself is inside the material: it counts as visible within the size of the break.
  const isSeen = (p: Pt) =>
    breaks.some((by) => isOutmost(body, at(p.z - by, p.r)) || isOutmost(body, at(p.z + by, p.r)));
  const inside = positions.filter(({ from: p }) => !isSeen(p));
  // An outline may run out beside the blank: a length begins at the part.
  const seen = positions
    .filter(({ from: p }) => isSeen(p))
    .map(({ size, from: p }) => {
      const near = breaks.flatMap((by) => [p.z - by - BESIDE, p.z + by + BESIDE]);
      const high = Math.max(...near.map((z) => spanAt(body, z)?.high ?? 0));
      return { size, from: at(p.z, high > 0 ? Math.min(high, p.r) : p.r) };
    });
  const { rows, count, middles } = leaderRows(
    notes,
    width,
    turnedTexts(
      inside.map(({ size, from: p }) => ({ size, from: place(p) })),
      upright,
    ),
  );
  const lengthsOf = (
    list: readonly Pick<(typeof positions)[number], "from" | "size">[],
    axis: number,
    side: "below" | "above",
    clear: readonly (readonly Place[])[] = [],
  ) => {
    const sign = side === "below" ? -1 : 1;
    const at0 = (p: Pt): Place => ({ x: x0 + p.z * k, y: axis - sign * p.r * k });
    const zero = at0(at(0, spanAt(body, -BESIDE)?.high ?? 0));
    const lengths: PrintLength[] = list.map(({ size, from: p }) => ({ size, from: at0(p) }));
    return drawnLengths(lengths, {
      zero,
      edge: axis - sign * half,
      side,
      width,
      clear,
      ...(side === "above" && middles.length > 0 && { middles }),
    });
  };
  const above = lengthsOf(inside, 0, "above").reach;
  const shelf = EDGE + Math.max(0, count - 1) * ROW + 6,
    axis = (count > 0 ? shelf + ABOVE : EDGE) + above + half;
  const onPaper = (p: Pt): Place => ({ x: x0 + p.z * k, y: axis - p.r * k });
  const lowered: readonly Row[] = rows.map((row) => ({
    ...row,
    leader: { ...row.leader, to: { ...row.leader.to, y: row.leader.to.y + axis } },
  }));

  const shapes: PrintShape[] = [];
  const texts: PrintText[] = [];
  shapes.push(
    ...bodyShapes(body, {
      broken,
      section: isHollow(body) ? "upper" : "none",
      onPaper,
      scale: k,
      threads: work.threads,
    }),
  );
  const [axisLeft, axisRight] = [onPaper(at(box.left, 0)).x - AXIS_PAST, onPaper(at(box.right, 0)).x + AXIS_PAST];
  shapes.push({
    role: "axis",
    d: lineThrough([
      { x: axisLeft, y: axis },
      { x: axisRight, y: axis },
    ]),
  });
  const drawnNotes = drawnLeaders(lowered, shelf, [axis - half - above, axis - half - TO_FEET]);
  const beside = (list: readonly Across[], side: 1 | -1) => {
    let x = onPaper(at(side > 0 ? box.right : box.left, 0)).x + side * (FIRST - NEXT_TO);
    for (const { size, r, left: a, right: b, isBore } of list) {
      // The text is on the left of its line, to be read from the right of the sheet.
      const tall = tallOf(size);
      const at0 = side > 0 ? x + tall + NEXT_TO : x - NEXT_TO;
      const [upper, lower] = [at(side > 0 ? b : a, r), at(side > 0 ? b : a, -r)].map(onPaper) as [Place, Place];
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
      const middle = down.find((y) => !isCrossed(drawnNotes.lines, text(y).box)) ?? axis;
      shapes.push(
        ...(isBore
          ? halfDimensionLine(top, { x: at0, y: middle + widthOf(size) / 2 + PAST_TEXT })
          : dimensionLine(top, { x: at0, y: lower.y })),
      );
      texts.push(text(middle));
      x = side > 0 ? at0 : at0 - tall;
    }
  };
  beside(right, 1);
  beside(left, -1);
  shapes.push(...drawnNotes.shapes);
  texts.push(...drawnNotes.texts);

  const below = lengthsOf(seen, axis, "below"),
    insides = lengthsOf(inside, axis, "above", drawnNotes.lines);
  for (const drawn of [below, insides]) {
    shapes.push(...drawn.shapes);
    texts.push(...drawn.texts);
  }
  const print = {
    scale,
    width,
    height: axis + half + below.reach + EDGE,
    shapes,
    texts,
    list: listed,
    general: marks.general === null ? null : words.roughness(marks.general),
    omitted: notes.length - rows.length,
    origin: { x: x0, y: axis },
  };
  return { print, isCrossed: insides.isCrossed };
}

type Row = Parameters<typeof drawnLeaders>[0][number];
