import { at, type Pt } from "../../kernel/geometry/point.ts";
import { toScreen, type Place, type Size } from "../camera.ts";
import { labelsOverlap, textWidth, type LabelBox } from "../dimensions/labels.ts";
import { dimensionLines, opening, type DimensionLines, type DimensionPaper } from "./dimension.ts";
import type { Figure } from "./figure.ts";

/** A dimension to place on a drawing. */
export interface MeasurementRequest {
  readonly id: string;
  readonly figure: Figure;
  readonly text: string;
  /** A second, smaller line under it; empty for none. */
  readonly caption: string;
  /** The middle of its text if placed by hand, mm of the part. */
  readonly put?: Pt;
}

/** A placed dimension: the middle and the box of its text, and its lines, in the units of the paper. */
export interface PlacedMeasurement extends DimensionLines {
  readonly id: string;
  readonly text: string;
  readonly caption: string;
  readonly middle: Place;
  readonly box: LabelBox;
}

/** A drawing with the room it has. */
export interface MeasurementPaper extends DimensionPaper {
  readonly size: Size;
  /** Space that scales and edges take. */
  readonly edges: { readonly left: number; readonly right: number; readonly top: number; readonly bottom: number };
  /** Boxes that no text may cover. */
  readonly kept: readonly LabelBox[];
}

/** Letters, pixels of a usual screen, and the box round them. */
export const MEASURED_TEXT = 13;
const PAD = 10,
  TALL = 20;
/** Letters of a caption, and the line that it takes. */
const CAPTION = { text: 11, tall: 13 } as const;
/** Offset of a text from its measured geometry, pixels: of the first line, and from line to line. */
const OFF = 26,
  ROW = 24;
/** Space beyond an arrow that points inwards, pixels. */
const OUTSIDE = 32;
const ROWS = [0, 1, 2, 3, 4, 5] as const;

const boxAt = (middle: Place, { text, caption }: MeasurementRequest, unit: number): LabelBox => {
  const width = Math.max(textWidth(text, MEASURED_TEXT * unit), textWidth(caption, CAPTION.text * unit)) + PAD * unit;
  const height = (TALL + (caption === "" ? 0 : CAPTION.tall)) * unit;
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
};

/** Offsets to either side, the nearest first. */
const sides = (step: number, count: number): readonly number[] =>
  Array.from({ length: 2 * count + 1 }, (_, i) => (i % 2 ? 1 : -1) * Math.ceil(i / 2) * step);

function alongside(a: Place, b: Place, wide: number, unit: number): Place[] {
  const isWide = Math.abs(a.x - b.x) > wide + 2 * OFF * unit;
  const x = isWide ? (a.x + b.x) / 2 : Math.max(a.x, b.x) + wide / 2 + OFF * unit;
  const top = Math.min(a.y, b.y),
    floor = Math.max(a.y, b.y);
  return ROWS.flatMap((row) => [
    { x, y: top - (OFF + row * ROW) * unit },
    { x, y: floor + (OFF + row * ROW) * unit },
  ]);
}

function upright(a: Place, b: Place, wide: number, unit: number): Place[] {
  const isTall = Math.abs(a.y - b.y) > (TALL + 2 * OFF) * unit;
  const y = isTall ? (a.y + b.y) / 2 : Math.min(a.y, b.y) - (TALL / 2 + 16) * unit;
  const [left, right] = [Math.min(a.x, b.x), Math.max(a.x, b.x)],
    step = wide / 2 + 12 * unit;
  return ROWS.flatMap((row) => [
    { x: right + (row + 1) * step, y },
    { x: left - (row + 1) * step, y },
  ]);
}

function beside(a: Place, b: Place, wide: number, unit: number): Place[] {
  const long = Math.hypot(b.x - a.x, b.y - a.y) || 1,
    across = { x: (b.y - a.y) / long, y: (a.x - b.x) / long };
  const up = across.y > 0 ? { x: -across.x, y: -across.y } : across,
    middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  const first = OFF * unit + (Math.abs(up.x) * wide) / 2;
  return ROWS.flatMap((row) =>
    [1, -1].map((side) => {
      const far = side * (first + row * ROW * unit);
      return { x: middle.x + up.x * far, y: middle.y + up.y * far };
    }),
  );
}

/** Places round a tip, the nearest first. */
function round(tip: Place, centre: Place, wide: number, unit: number): Place[] {
  const out = Math.atan2(tip.y - centre.y, tip.x - centre.x);
  return ROWS.slice(0, 4).flatMap((row) =>
    sides(Math.PI / 6, 5).map((turn) => {
      const far = (OFF + 8 + row * ROW) * unit,
        way = out + turn;
      return { x: tip.x + Math.cos(way) * (far + wide / 3), y: tip.y + Math.sin(way) * far };
    }),
  );
}

/**
 * The directions in which the text of an angle may be placed, from its first leg: within the angle, or beside it if the
 * angle is narrow.
 */
function waysOf(sweep: number, far: number): readonly number[] {
  const beside = (OUTSIDE / far) * (Math.sign(sweep) || 1),
    out = [sweep + beside, -beside];
  return Math.abs(sweep) * far < TALL + OFF ? out : [...[0.5, 0.3, 0.7].map((share) => share * sweep), ...out];
}

/** Candidate places for the text of a dimension, the best first. */
function middles(paper: MeasurementPaper, figure: Figure, wide: number): Place[] {
  const { camera, unit } = paper;
  switch (figure.kind) {
    case "diameter": {
      const tip = toScreen(camera, figure.at),
        centre = toScreen(camera, at(figure.at.z, 0));
      const up = tip.y - centre.y,
        out = up + Math.sign(up) * OUTSIDE * unit;
      const rows = Math.abs(up) < (TALL + OFF) * unit ? [out, -out] : [0.5, 0.28, 0.74, -0.5].map((k) => k * up);
      return sides(wide / 2 + 8 * unit, 5).flatMap((x) => rows.map((y) => ({ x: tip.x + x, y: centre.y + y })));
    }
    case "circle":
      return round(toScreen(camera, figure.at), toScreen(camera, figure.centre), wide, unit);
    case "radius":
      return round(toScreen(camera, figure.tip), toScreen(camera, figure.centre), wide, unit);
    case "angle": {
      const { centre, start, sweep } = opening(paper, figure);
      return [2, 3, 4, 5, 6].flatMap((far) =>
        waysOf(sweep, far * OFF).map((off) => {
          const way = start + off;
          return {
            x: centre.x + Math.cos(way) * (far * OFF * unit + wide / 4),
            y: centre.y - Math.sin(way) * far * OFF * unit,
          };
        }),
      );
    }
    case "along":
      return alongside(toScreen(camera, figure.from), toScreen(camera, figure.to), wide, unit);
    case "across":
      return upright(toScreen(camera, figure.from), toScreen(camera, figure.to), wide, unit);
    case "straight":
      return beside(toScreen(camera, figure.from), toScreen(camera, figure.to), wide, unit);
  }
}

const shared = (a: LabelBox, b: LabelBox): number =>
  Math.max(0, Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x)) *
  Math.max(0, Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y));

const isInside = (b: LabelBox, { size, edges }: MeasurementPaper): boolean =>
  b.x >= edges.left &&
  b.y >= edges.top &&
  b.x + b.width <= size.width - edges.right &&
  b.y + b.height <= size.height - edges.bottom;

/** A middle moved the shortest way to where its box is fully on the paper. */
function movedInside(p: Place, box: LabelBox, { size, edges }: MeasurementPaper): Place {
  const inside = (v: number, half: number, low: number, high: number) => Math.max(low + half, Math.min(v, high - half));
  return {
    x: inside(p.x, box.width / 2, edges.left, size.width - edges.right),
    y: inside(p.y, box.height / 2, edges.top, size.height - edges.bottom),
  };
}

/** The first item with the least number. */
function leastOf<Each>(all: readonly Each[], numberOf: (each: Each) => number): Each | undefined {
  let best: Each | undefined,
    least = Infinity;
  for (const each of all) {
    const number = least > 0 ? numberOf(each) : Infinity;
    if (number >= least) continue;
    best = each;
    least = number;
  }
  return best;
}

/** The straight pieces of path data; an arc counts as its chord. */
function piecesOf(lines: string): readonly (readonly [Place, Place])[] {
  const pieces: [Place, Place][] = [];
  let last: Place | null = null;
  for (const [, letter, numbers = ""] of lines.matchAll(/([MLA])([^MLA]*)/g)) {
    const [y = 0, x = 0] = numbers.trim().split(/\s+/).map(Number).toReversed(),
      here = { x, y };
    if (letter !== "M" && last) pieces.push([last, here]);
    last = here;
  }
  return pieces;
}

/** True where a line runs through a box. */
function runsThrough([a, b]: readonly [Place, Place], { x, y, width, height }: LabelBox): boolean {
  let [low, high] = [0, 1];
  for (const [from, way, least, most] of [
    [a.x, b.x - a.x, x, x + width],
    [a.y, b.y - a.y, y, y + height],
  ] as const) {
    if (way === 0 && (from <= least || from >= most)) return false;
    if (way === 0) continue;
    const ends = [(least - from) / way, (most - from) / way];
    low = Math.max(low, Math.min(...ends));
    high = Math.min(high, Math.max(...ends));
  }
  return low < high;
}

/** A placed dimension, with the pieces of its lines. */
interface Standing {
  readonly made: PlacedMeasurement;
  readonly pieces: readonly (readonly [Place, Place])[];
}

/** How many texts and lines cross each other, between one dimension and others with the kept boxes. */
function crossings(
  { made: { box }, pieces }: Standing,
  others: readonly Standing[],
  kept: readonly LabelBox[],
): number {
  const texts = [...kept, ...others.map(({ made }) => made.box)];
  return (
    texts.filter((text) => pieces.some((piece) => runsThrough(piece, text))).length +
    others.filter((other) => other.pieces.some((piece) => runsThrough(piece, box))).length
  );
}

/** The best place for a dimension among the placed ones. */
function placed(paper: MeasurementPaper, each: MeasurementRequest, others: readonly Standing[]): Standing | undefined {
  const { unit } = paper,
    taken = [...paper.kept, ...others.map(({ made }) => made.box)];
  const possible = middles(paper, each.figure, boxAt({ x: 0, y: 0 }, each, unit).width);
  const covers = (p: Place) => taken.reduce((sum, t) => sum + shared(t, boxAt(p, each, unit)), 0);
  const free = possible.filter((p) => {
    const box = boxAt(p, each, unit);
    return isInside(box, paper) && !taken.some((t) => labelsOverlap(t, box));
  });
  if (free.length > 0)
    return leastOf(
      free.map((p) => standing(paper, each, p)),
      (s) => crossings(s, others, paper.kept),
    );
  const moved = possible.map((p) => movedInside(p, boxAt(p, each, unit), paper)),
    least = leastOf(moved, covers);
  return least && standing(paper, each, least);
}

function standing(paper: MeasurementPaper, each: MeasurementRequest, middle: Place): Standing {
  const { id, figure, text, caption } = each,
    box = boxAt(middle, each, paper.unit),
    own = dimensionLines(paper, figure, middle);
  return { made: { id, text, caption, middle, box, ...own }, pieces: piecesOf(own.lines) };
}

/**
 * Places dimensions on a drawing, in their order: a text placed by hand stays; each of the others goes where it covers
 * no other text, and of such places to the first with the fewest crossings of lines and texts. Without a free place it
 * takes the one that covers least. Then each dimension that a later one's line crosses is placed once more.
 */
export function placedMeasurements(
  paper: MeasurementPaper,
  asked: readonly MeasurementRequest[],
): readonly PlacedMeasurement[] {
  const out = new Map<string, Standing>();
  const othersOf = (id: string) => [...out.values()].filter(({ made }) => made.id !== id);
  for (const each of asked) if (each.put) out.set(each.id, standing(paper, each, toScreen(paper.camera, each.put)));
  const free = asked.filter(({ put }) => !put);
  for (const each of free) {
    const first = placed(paper, each, [...out.values()]);
    if (first) out.set(each.id, first);
  }
  for (const each of free) {
    const now = out.get(each.id),
      others = othersOf(each.id),
      crossed = now ? crossings(now, others, paper.kept) : 0;
    const again = crossed > 0 ? placed(paper, each, others) : undefined;
    if (again && crossings(again, others, paper.kept) < crossed) out.set(each.id, again);
  }
  return asked.flatMap(({ id }) => out.get(id)?.made ?? []);
}
