import type { Clamped } from "../../kernel/area/clamping.ts";
import type { Pt, Ring, Segment } from "../../kernel/geometry/point.ts";
import { at, part } from "../../kernel/geometry/point.ts";
import { type Diameter, toDiameter } from "../../kernel/units.ts";
import { boundsOf, joined, mirrored } from "../bounds.ts";
import type { Place } from "../camera.ts";
import { clampingNear } from "./clamping-on-paper.ts";
import { unstatedClamping } from "../unstated-clamping.ts";
import { textWidth, type LabelBox } from "../dimensions/labels.ts";
import { featuresOf, type DiameterFeature, type PositionFeature, type TurnedContour } from "./features.ts";
import type { DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { measuredOnPaper } from "./measured.ts";
import { factorOf, usualScale, type DrawingScale } from "./scales.ts";
import { FIGURES } from "./sizes.ts";
import { spread } from "../dimensions/spread.ts";

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

/** What a line or an area of the drawing stands for; its weight and dashes belong to whoever paints it. */
export type DrawingRole =
  | "chuck"
  | "chuckEdge"
  | "blank"
  | "section"
  | "outline"
  | "edge"
  | "axis"
  | "thin"
  | "arrow"
  | "zero"
  | "zeroFilled"
  | "measured";

export interface DrawnShape {
  readonly role: DrawingRole;
  /** Path data, mm on paper. */
  readonly d: string;
}

/** A text with the middle of its box; a turned one reads from the right. */
export interface DrawnText {
  readonly text: string;
  readonly at: Place;
  readonly turned: boolean;
  readonly box: LabelBox;
}

/** The drawing of a set-up, all places in mm on paper from its top left corner. */
export interface PartDrawing {
  readonly scale: DrawingScale;
  readonly width: number;
  readonly height: number;
  /** From back to front. */
  readonly shapes: readonly DrawnShape[];
  readonly texts: readonly DrawnText[];
  /** Number of dimensions without room. */
  readonly omitted: number;
}

/** The height that a figure takes, mm on paper. */
const LINE = 3.9;
/**
 * Least gap between two labels; from a part to the first dimension; from the knee of a leader to its text, mm on paper.
 */
const GAP = 0.5,
  OFF = 6,
  KNEE = 5;
const ARROW = { long: 2.4, wide: 0.75 } as const;
const EDGE = 2;
/** Radius of the sign at the workpiece zero, and how far its axes point, mm on paper. */
const ZERO = 1.6;
/** Arcs stay this near to their circle, mm on paper. */
const CHORD_ON_PAPER = 0.05;

const mm = (v: number): string => String(Math.round(v * 100) / 100 + 0);
const lineThrough = (places: readonly Place[]): string => `M${places.map(({ x, y }) => `${mm(x)} ${mm(y)}`).join("L")}`;

function arrow(tip: Place, dx: number, dy: number): string {
  const back = { x: tip.x - dx * ARROW.long, y: tip.y - dy * ARROW.long };
  const side = (by: number): Place => ({ x: back.x - dy * by, y: back.y + dx * by });
  return `${lineThrough([tip, side(ARROW.wide), side(-ARROW.wide)])}Z`;
}

const wide = (text: string): number => textWidth(text, FIGURES) + 1;

/** Features closer to a larger one than this are left out, mm: no line between them would show on paper. */
const APART = 0.35;
const distinct = <F extends { readonly extent: number }>(
  features: readonly F[],
  along: (feature: F) => number,
): readonly F[] =>
  features.filter(
    (f) =>
      !features.some((other) => other.extent > f.extent && f.extent === 0 && Math.abs(along(other) - along(f)) < APART),
  );

/** The features that show most, as many as have room, in the order of the paper. */
function placed<F extends { readonly extent: number }>(
  features: readonly F[],
  along: (feature: F) => number,
  size: (feature: F) => number,
  [low, high]: readonly [number, number],
): { readonly feature: F; readonly middle: number }[] {
  const shown = [...features].sort((a, b) => b.extent - a.extent);
  for (let n = shown.length; n > 0; n -= 1) {
    const some = shown.slice(0, n).sort((a, b) => along(a) - along(b));
    const middles = spread(
      some.map((f) => ({ at: along(f), size: size(f) })),
      low,
      high,
      GAP,
    );
    if (middles) return some.map((feature, i) => ({ feature, middle: middles[i] ?? 0 }));
  }
  return [];
}

/** Below this radius a surface is on the axis, mm. */
const ON_AXIS = 0.0005;

/** A ring as lines, without the sides on the axis, where two halves meet. */
function offAxis(ring: Ring): readonly (readonly Pt[])[] {
  const isOn = (i: number) =>
    [ring[i], ring[(i + 1) % ring.length]].every((p) => p !== undefined && Math.abs(p.r) < ON_AXIS);
  const first = ring.findIndex((_, i) => isOn(i));
  if (first < 0) return ring.length > 1 ? [[...ring, ...ring.slice(0, 1)]] : [];
  const lines: Pt[][] = [];
  let line: Pt[] = [];
  for (let k = 1; k <= ring.length; k += 1) {
    const i = (first + k) % ring.length,
      p = ring[i];
    if (p) line.push(p);
    if (!isOn(i)) continue;
    if (line.length > 1) lines.push(line);
    line = [];
  }
  return lines;
}

/** Lines across the bore at its shoulders, visible behind the cut. */
function boreEdges(
  finished: readonly Ring[],
  positions: readonly PositionFeature[],
  onPaper: (p: Pt) => Place,
): string {
  const corners = finished.flatMap((ring) =>
    ring.filter((p, i) => isCorner(ring, i) && positions.some(({ at: { z } }) => Math.abs(z - p.z) < SHOULDER)),
  );
  const free = corners.filter((p) => p.r > SHOULDER && !finished.some((ring) => standsBelow(ring, p)));
  return free.map((p) => lineThrough([onPaper(p), onPaper(mirror(p))])).join("");
}

/** A corner is one of a shoulder within this, mm. */
const SHOULDER = 0.05;

const mirror = (p: Pt): Pt => at(p.z, -p.r);

/** Whether a ring has material between the axis and a point straight above it. */
const standsBelow = (ring: Ring, p: Pt): boolean =>
  ring.some((a, i) => {
    const b = ring[(i + 1) % ring.length] ?? a;
    return [p.z - BESIDE, p.z + BESIDE].some(
      (z) => a.z > z !== b.z > z && a.r + ((z - a.z) / (b.z - a.z)) * (b.r - a.r) < p.r - SHOULDER,
    );
  });

/** Offset of the probes for material on either side of a corner, mm. */
const BESIDE = 0.01;

/** A corner of the part rather than a point of a flattened arc: the sine of the turn at it. */
const SHARP = 0.3;

function isCorner(ring: Ring, i: number): boolean {
  const [a, p, b] = [ring[(i + ring.length - 1) % ring.length], ring[i], ring[(i + 1) % ring.length]];
  if (!a || !p || !b) return false;
  const [before, after] = [Math.hypot(p.z - a.z, p.r - a.r), Math.hypot(b.z - p.z, b.r - p.r)];
  if (before === 0 || after === 0) return false;
  const turn = ((p.z - a.z) * (b.r - p.r) - (p.r - a.r) * (b.z - p.z)) / (before * after);
  return Math.abs(turn) > SHARP;
}

/** The sign of the workpiece zero: a circle, two opposite quarters of it filled. */
function zeroSign({ x, y }: Place): readonly DrawnShape[] {
  const quarter = (fx: number, fy: number) =>
    `M${mm(x)} ${mm(y)}L${mm(x + fx * ZERO)} ${mm(y)}A${ZERO} ${ZERO} 0 0 ${fx * fy > 0 ? 1 : 0} ${mm(x)} ${mm(y + fy * ZERO)}Z`;
  return [
    {
      role: "zero",
      d: `M${mm(x - ZERO)} ${mm(y)}a${ZERO} ${ZERO} 0 1 1 ${ZERO + ZERO} 0a${ZERO} ${ZERO} 0 1 1 ${-ZERO - ZERO} 0Z`,
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
  const marks: readonly PositionFeature[] = positions.some(({ at: { z } }) => Math.abs(z) < SHOULDER)
    ? positions
    : [{ at: at(0, 0), extent: Infinity }, ...positions];
  const saidPosition = ({ at: { z }, ofBlank }: PositionFeature) =>
    ofBlank ? `(${words.position(z)})` : words.position(z);
  const column = diameters.length > 0 ? Math.max(...diameters.map((d) => wide(saidDiameter(d)))) + OFF + KNEE : OFF;
  const row = Math.max(...marks.map((p) => wide(saidPosition(p)))) + KNEE + 2;
  const top = LINE + OFF;
  const inner = { wide: room.width - column - EDGE - EDGE, tall: room.height - top - row };
  const scale = usualScale({ wide: all.right - all.left, tall: all.high - all.low }, inner);
  const k = factorOf(scale);
  const [long, tall] = [(all.right - all.left) * k, (all.high - all.low) * k];
  const needed = diameters.length * (LINE + GAP);
  const height = Math.min(room.height, Math.max(tall + top + row, needed + row));
  const left = Math.max(EDGE, (room.width - column - long) / 2);
  const zero: Place = { x: left - all.left * k, y: top + (height - top - row) / 2 };
  const onPaper = (p: Pt): Place => ({ x: zero.x + p.z * k, y: zero.y - p.r * k });
  const ringsOnPaper = (rings: readonly Ring[]) =>
    rings
      .filter((ring) => ring.length > 2)
      .map((ring) => `${lineThrough(ring.map(onPaper))}Z${lineThrough(ring.map((p) => onPaper(mirror(p))))}Z`)
      .join("");
  const bothHalves = (line: readonly Pt[]) =>
    lineThrough(line.map(onPaper)) + lineThrough(line.map((p) => onPaper(mirror(p))));
  const shapes: DrawnShape[] = [];
  const texts: DrawnText[] = [];
  if (clamping.areas.length > 0) {
    shapes.push({ role: "chuck", d: ringsOnPaper(clamping.areas) });
    shapes.push({ role: "chuckEdge", d: clamping.edges.map(bothHalves).join("") });
  }
  if (held) shapes.push({ role: "edge", d: [held.plane, ...held.hatch].map(bothHalves).join("") });
  shapes.push({ role: "section", d: ringsOnPaper(work.finished) });
  shapes.push({
    role: "outline",
    d: work.finished
      .flatMap(offAxis)
      .map((line) => bothHalves(line))
      .join(""),
  });
  shapes.push({ role: "edge", d: boreEdges(work.finished, positions, onPaper) });
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

  const writeAt = (text: string, middle: Place, turned: boolean) => {
    const size = wide(text),
      box = turned
        ? { x: middle.x - LINE / 2, y: middle.y - size / 2, width: LINE, height: size }
        : { x: middle.x - size / 2, y: middle.y - LINE / 2, width: size, height: LINE };
    texts.push({ text, at: middle, turned, box });
  };
  const right = left + long + OFF;
  const seen = ({ at: p, outside }: DiameterFeature) => onPaper(outside ? p : mirror(p));
  const shownDiameters = placed(
    distinct(diameters, (d) => seen(d).y),
    (d) => seen(d).y,
    () => LINE,
    [0, height - row],
  );
  for (const { feature, middle } of shownDiameters) {
    const from = seen(feature),
      text = saidDiameter(feature),
      x = right + KNEE;
    shapes.push({ role: "thin", d: lineThrough([from, { x: Math.max(right, from.x), y: from.y }, { x, y: middle }]) });
    shapes.push({ role: "arrow", d: dot(from) });
    writeAt(text, { x: x + GAP + wide(text) / 2, y: middle }, false);
  }
  const floor = height - row;
  const shownPositions = placed(
    distinct(marks, (p) => onPaper(p.at).x),
    (p) => onPaper(p.at).x,
    () => LINE,
    [0, room.width - column],
  );
  for (const { feature, middle } of shownPositions) {
    const from = onPaper(mirror(feature.at)),
      text = saidPosition(feature);
    const until = Math.max(floor, from.y),
      y = until + KNEE;
    shapes.push({ role: "thin", d: lineThrough([from, { x: from.x, y: until }, { x: middle, y }]) });
    writeAt(text, { x: middle, y: y + GAP + wide(text) / 2 }, true);
  }
  if (material) {
    const [a, b] = [zero.x + material.left * k, zero.x + material.right * k],
      y = zero.y - all.high * k - OFF / 2;
    const outer = zero.y - material.high * k;
    shapes.push({
      role: "thin",
      d:
        lineThrough([
          { x: a, y: outer },
          { x: a, y: y - 1 },
        ]) +
        lineThrough([
          { x: b, y: outer },
          { x: b, y: y - 1 },
        ]) +
        lineThrough([
          { x: a, y },
          { x: b, y },
        ]),
    });
    shapes.push({ role: "arrow", d: arrow({ x: a, y }, -1, 0) + arrow({ x: b, y }, 1, 0) });
    const text = words.blankLength(material.right - material.left),
      half = wide(text) / 2;
    writeAt(text, { x: Math.max(half, Math.min((a + b) / 2, right + KNEE - half)), y: y - LINE / 2 - 0.4 }, false);
  }
  shapes.push(...zeroSign(zero));
  const camera = { scale: k, zero, xUp: true };
  for (const each of measuredOnPaper(work.measured ?? [], {
    camera,
    width: room.width,
    height,
    kept: texts.map(({ box }) => box),
  })) {
    const { x, y, width, height: tall } = each.box;
    shapes.push(
      { role: "thin", d: each.lines },
      { role: "arrow", d: each.arrows },
      { role: "measured", d: each.frame },
    );
    texts.push({ text: each.text, at: { x: x + width / 2, y: y + tall / 2 }, turned: false, box: each.box });
  }
  const wanted = distinct(diameters, (d) => seen(d).y).length + distinct(marks, (p) => onPaper(p.at).x).length;
  const missing = wanted - shownDiameters.length - shownPositions.length;
  return { scale, width: room.width, height, shapes, texts, omitted: missing };
}

/** The end of a leader on a surface. */
const DOT = 0.45;
const dot = ({ x, y }: Place): string =>
  `M${mm(x - DOT)} ${mm(y)}a${DOT} ${DOT} 0 1 1 ${DOT + DOT} 0a${DOT} ${DOT} 0 1 1 ${-DOT - DOT} 0Z`;
