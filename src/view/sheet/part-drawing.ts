import type { Clamped } from "../../kernel/area/clamping.ts";
import type { Pt, Ring, Segment } from "../../kernel/geometry/point.ts";
import { at, part } from "../../kernel/geometry/point.ts";
import { type Diameter, toDiameter } from "../../kernel/units.ts";
import { boundsOf, joined, mirrored } from "../bounds.ts";
import type { Place } from "../camera.ts";
import { clampingNear } from "./clamping-on-paper.ts";
import { unstatedClamping } from "../unstated-clamping.ts";
import { middleOf } from "../dimensions/labels.ts";
import { bodyShapes, mirroredAt } from "../drawing/body.ts";
import { dimensionLine, LINE, widthOf, writtenAt, type PrintShape, type PrintText } from "../drawing/paper.ts";
import { circleAt, lineThrough, onPaperGrid } from "../dimensions/strokes.ts";
import { featuresOf, type DiameterFeature, type PositionFeature, type TurnedContour } from "./features.ts";
import type { DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { measuredOnPaper } from "./measured.ts";
import { factorOf, usualScale, type DrawingScale } from "./scales.ts";
import { mostThatFit, spread } from "../dimensions/spread.ts";

/** What is drawn. Part space, mm. */
export interface DrawnWork {
  readonly blank: readonly Ring[];
  /** The part at the end. */
  readonly finished: readonly Ring[];
  readonly contours: readonly TurnedContour[];
  /** The clamping; null or absent if not stated. */
  readonly clamping?: Clamped | null;
  /** Measurements on the part; none if absent. */
  readonly measured?: readonly DimensionRequest[];
}

/** Words and numbers as the sheet's language writes them. */
export interface DrawingWords {
  readonly diameter: (value: Diameter) => string;
  readonly position: (value: number) => string;
  readonly thread: (diameter: string, lead: number, starts: number) => string;
  /** The length of the blank over all. */
  readonly blankLength: (value: number) => string;
}

/** The drawing of a set-up, all places in mm on paper from its top left corner. */
export interface PartDrawing {
  readonly scale: DrawingScale;
  readonly width: number;
  readonly height: number;
  /** From back to front. */
  readonly shapes: readonly PrintShape[];
  readonly texts: readonly PrintText[];
  /** Number of dimensions without room. */
  readonly omitted: number;
}

/**
 * Least gap between two labels; from a part to the first dimension; from the knee of a leader to its text, mm on paper.
 */
const GAP = 0.5,
  OFF = 6,
  KNEE = 5;
const EDGE = 2;
/** Radius of the sign at the workpiece zero, and how far its axes point, mm on paper. */
const ZERO = 1.6;
/** Arcs stay this near to their circle, mm on paper. */
const CHORD_ON_PAPER = 0.05;

const widthIn = (text: string): number => widthOf({ text }) + 1;

/**
 * Nearer features cannot be told apart, mm on paper: a smaller one is left out, of the two ends of a slope the one
 * farther from the surface.
 */
const APART = 0.35;
const distinct = <F extends PositionFeature>(features: readonly F[], along: (feature: F) => number): readonly F[] =>
  features.filter((f) => {
    const isBetter = ({ at: p, extent }: F) => extent > 0 || p.z + p.r > f.at.z + f.at.r;
    return f.extent > 0 || !features.some((other) => isBetter(other) && Math.abs(along(other) - along(f)) < APART);
  });

/** The features that show most, as many as have room, in the order of the paper. */
function placed<F extends { readonly extent: number }>(
  features: readonly F[],
  along: (feature: F) => number,
  [low, high]: readonly [number, number],
): { readonly feature: F; readonly middle: number }[] {
  const ranked = [...features].sort((a, b) => b.extent - a.extent);
  const laid = mostThatFit(ranked, (shown) => {
    const some = shown.toSorted((a, b) => along(a) - along(b));
    const middles = spread(
      some.map((f) => ({ at: along(f), size: LINE.plain })),
      low,
      high,
      GAP,
    );
    return middles && some.map((feature, i) => ({ feature, middle: middles[i] ?? 0 }));
  });
  return laid ?? [];
}

/** Nearer along the axis is one place, mm. */
const ONE_PLACE = 0.05;

/** The sign of the workpiece zero: a circle, two opposite quarters of it filled. */
function zeroSign({ x, y }: Place): readonly PrintShape[] {
  const quarter = (fx: number, fy: number) =>
    `M${onPaperGrid(x)} ${onPaperGrid(y)}L${onPaperGrid(x + fx * ZERO)} ${onPaperGrid(y)}A${ZERO} ${ZERO} 0 0 ${fx * fy > 0 ? 1 : 0} ${onPaperGrid(x)} ${onPaperGrid(y + fy * ZERO)}Z`;
  return [
    {
      role: "zero",
      d: circleAt({ x, y }, ZERO),
    },
    { role: "zeroFilled", d: quarter(1, -1) + quarter(-1, 1) },
  ];
}

/**
 * A set-up to scale within a width and a greatest height, mm on paper: blank, chuck, finished part in section, zero,
 * with diameters in a column on the right and positions in a row below, without overlaps. Null if there is nothing to
 * draw.
 */
export function partDrawing(
  work: DrawnWork,
  words: DrawingWords,
  room: { readonly width: number; readonly height: number },
): PartDrawing | null {
  const material = boundsOf(work.blank.flat());
  const outline = boundsOf(work.contours.flatMap(({ segments }) => segments.flatMap(({ from, to }) => [from, to])));
  const body = joined(material, joined(boundsOf(work.finished.flat()), outline));
  if (!body) return null;
  const held = material && !work.clamping ? unstatedClamping(work.blank, material) : null;
  const clamping = material && work.clamping ? clampingNear(work.clamping, material) : { areas: [], edges: [] };
  const holding = boundsOf([...clamping.areas.flat(), ...(held?.hatch.flat() ?? [])]);
  const all = mirrored(joined(joined(body, holding), boundsOf([at(0, 0)])) ?? body);
  const { diameters, positions } = featuresOf(work.contours, work.finished, work.blank);
  const saidDiameter = ({ at: { r }, thread, ofBlank }: DiameterFeature) => {
    const own = words.diameter(toDiameter(r));
    if (ofBlank) return `(${own})`;
    return thread ? words.thread(own, thread.lead, thread.starts) : own;
  };
  const marks: readonly PositionFeature[] = positions.some(({ at: { z } }) => Math.abs(z) < ONE_PLACE)
    ? positions
    : [{ at: at(0, 0), extent: Infinity }, ...positions];
  const saidPosition = ({ at: { z }, ofBlank }: PositionFeature) =>
    ofBlank ? `(${words.position(z)})` : words.position(z);
  const column = diameters.length > 0 ? Math.max(...diameters.map((d) => widthIn(saidDiameter(d)))) + OFF + KNEE : OFF;
  const row = Math.max(...marks.map((p) => widthIn(saidPosition(p)))) + KNEE + 2;
  const top = LINE.plain + OFF;
  const inner = { wide: room.width - column - EDGE - EDGE, tall: room.height - top - row };
  const scale = usualScale({ wide: all.right - all.left, tall: all.high - all.low }, inner);
  const k = factorOf(scale);
  const [long, tall] = [(all.right - all.left) * k, (all.high - all.low) * k];
  const needed = diameters.length * (LINE.plain + GAP);
  const height = Math.min(room.height, Math.max(tall + top + row, needed + row));
  const left = Math.max(EDGE, (room.width - column - long) / 2);
  const zero: Place = { x: left - all.left * k, y: top + (height - top - row) / 2 };
  const onPaper = (p: Pt): Place => ({ x: zero.x + p.z * k, y: zero.y - p.r * k });
  const ringsOnPaper = (rings: readonly Ring[]) =>
    rings
      .filter((ring) => ring.length > 2)
      .map((ring) => `${lineThrough(ring.map(onPaper))}Z${lineThrough(ring.map((p) => onPaper(mirroredAt(p))))}Z`)
      .join("");
  const bothHalves = (line: readonly Pt[]) =>
    lineThrough(line.map(onPaper)) + lineThrough(line.map((p) => onPaper(mirroredAt(p))));
  const shapes: PrintShape[] = [];
  const texts: PrintText[] = [];
  if (clamping.areas.length > 0) {
    shapes.push({ role: "chuck", d: ringsOnPaper(clamping.areas) });
    shapes.push({ role: "chuckEdge", d: clamping.edges.map(bothHalves).join("") });
  }
  // Simulated threads have an edge at each tooth: only shoulders are drawn across the bore.
  const hasEdge = ({ z }: Pt) => positions.some(({ at: p }) => Math.abs(p.z - z) < ONE_PLACE);
  if (held) shapes.push({ role: "edge", d: [held.plane, ...held.hatch].map(bothHalves).join("") });
  shapes.push(
    ...bodyShapes(work.finished, { broken: null, section: "whole", hasEdge, onPaper, scale: k, threads: [] }),
  );
  if (work.blank.length > 0) shapes.push({ role: "blank", d: ringsOnPaper(work.blank) });
  const contourLine = (segments: readonly Segment[]) => {
    const line = part.flattenedChain(segments, CHORD_ON_PAPER / k);
    return line.length < 2 ? "" : bothHalves(line);
  };
  const unfinished =
    work.finished.length === 0 ? work.contours.map(({ segments }) => contourLine(segments)).join("") : "";
  if (unfinished) shapes.push({ role: "edge", d: unfinished });
  shapes.push({
    role: "axis",
    d: lineThrough([
      { x: left - EDGE, y: zero.y },
      { x: left + long + EDGE, y: zero.y },
    ]),
  });

  const writeAt = (text: string, middle: Place, turned: boolean) =>
    void texts.push(writtenAt({ text }, middle, turned));
  const right = left + long + OFF;
  const seen = ({ at: p, outside }: DiameterFeature) => onPaper(outside ? p : mirroredAt(p));
  const shownDiameters = placed(
    distinct(diameters, (d) => seen(d).y),
    (d) => seen(d).y,
    [0, height - row],
  );
  for (const { feature, middle } of shownDiameters) {
    const from = seen(feature),
      text = saidDiameter(feature),
      x = right + KNEE;
    shapes.push({ role: "thin", d: lineThrough([from, { x: Math.max(right, from.x), y: from.y }, { x, y: middle }]) });
    shapes.push({ role: "arrow", d: circleAt(from, DOT) });
    writeAt(text, { x: x + GAP + widthIn(text) / 2, y: middle }, false);
  }
  const floor = height - row;
  const shownPositions = placed(
    distinct(marks, (p) => onPaper(p.at).x),
    (p) => onPaper(p.at).x,
    [0, room.width - column],
  );
  for (const { feature, middle } of shownPositions) {
    const from = onPaper(mirroredAt(feature.at)),
      text = saidPosition(feature);
    const until = Math.max(floor, from.y),
      y = until + KNEE;
    shapes.push({ role: "thin", d: lineThrough([from, { x: from.x, y: until }, { x: middle, y }]) });
    writeAt(text, { x: middle, y: y + GAP + widthIn(text) / 2 }, true);
  }
  if (material) {
    const [a, b] = [zero.x + material.left * k, zero.x + material.right * k],
      y = zero.y - all.high * k - OFF / 2;
    const outer = zero.y - material.high * k;
    for (const x of [a, b])
      shapes.push({
        role: "thin",
        d: lineThrough([
          { x, y: outer },
          { x, y: y - 1 },
        ]),
      });
    shapes.push(...dimensionLine({ x: a, y }, { x: b, y }));
    const text = words.blankLength(material.right - material.left),
      half = widthIn(text) / 2;
    writeAt(
      text,
      { x: Math.max(half, Math.min((a + b) / 2, right + KNEE - half)), y: y - LINE.plain / 2 - 0.4 },
      false,
    );
  }
  shapes.push(...zeroSign(zero));
  const camera = { scale: k, zero, xUp: true };
  const { measured = [] } = work,
    kept = texts.map(({ box }) => box),
    shownMeasured = measuredOnPaper(measured, { camera, width: room.width, height, kept });
  for (const each of shownMeasured) {
    shapes.push(
      { role: "thin", d: each.lines },
      { role: "arrow", d: each.arrows },
      { role: "measured", d: each.frame },
    );
    writeAt(each.text, middleOf(each.box), false);
  }
  const wanted = distinct(diameters, (d) => seen(d).y).length + distinct(marks, (p) => onPaper(p.at).x).length;
  const shown = shownDiameters.length + shownPositions.length + shownMeasured.length;
  return { scale, width: room.width, height, shapes, texts, omitted: wanted + measured.length - shown };
}

/** The end of a leader on a surface. */
const DOT = 0.45;
