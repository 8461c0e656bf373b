import { at, type Pt } from "../../kernel/geometry/point.ts";
import { toScreen, type Place, type Size } from "../camera.ts";
import { arrange, type Item, type Placed, type Spot } from "./arrange.ts";
import type { Dimension, DimensionOf } from "./dimension.ts";
import { drawnDimension, opening, type DimensionScale, type DrawnDimension } from "./drawn-dimension.ts";
import { boxAbout, movedInto, textWidth, type LabelBox } from "./labels.ts";

/** A dimension to place on a drawing. */
export interface DimensionRequest {
  readonly key: string;
  readonly measured: Dimension;
  readonly text: string;
  /** A second, smaller line under it. */
  readonly caption?: string;
  /** Always placed; others only in sight, and where there is room. */
  readonly needed: boolean;
  /** The middle of its text if placed by hand, mm of the part. */
  readonly put?: Pt;
}

/** A placed dimension: the box of its text, and its lines, in the units of the paper. */
export interface PlacedDimension extends DrawnDimension {
  readonly key: string;
  readonly box: LabelBox;
}

/** A drawing with the room it has. */
export interface DimensionPaper extends DimensionScale {
  readonly size: Size;
  /** Where texts may be: clear of scales and edges. */
  readonly room: LabelBox;
  /** Boxes that no text may cover. */
  readonly kept: readonly LabelBox[];
  /** Points of the drawing that a text should avoid. */
  readonly avoid?: readonly Place[];
  /** Least size of a text that can be pressed. */
  readonly target?: Size;
  /** Left and upper edge of the areas that the part leaves free: diameters stand on the right, positions below. */
  readonly free?: Place;
}

/** Letters, pixels of a usual screen, and the box round them. */
export const DIMENSION_TEXT = 13;
const PAD = 10,
  TALL = 20;
/** Letters of a caption, and the line that it takes. */
const CAPTION = { text: 11, tall: 13 } as const;
/** Offset of a text from its measured geometry, pixels: of the first line, and from line to line. */
const OFF = 26,
  ROW = 24;
/** Space beyond an arrow that points inwards, pixels. */
const OUTSIDE = 32;
/** Gap between the texts of ordinates, and from them to the edge of the room, pixels. */
const AIR = 2;
const ROWS = [0, 1, 2, 3, 4, 5] as const;

function sizeOf({ text, caption = "" }: DimensionRequest, { unit, target }: DimensionPaper): Size {
  const width = Math.max(textWidth(text, DIMENSION_TEXT * unit), textWidth(caption, CAPTION.text * unit)) + PAD * unit;
  const height = (TALL + (caption === "" ? 0 : CAPTION.tall)) * unit;
  return { width: Math.max(width, target?.width ?? 0), height: Math.max(height, target?.height ?? 0) };
}

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

/** Places round a tip, the nearest to a direction first. */
function round(tip: Place, out: Place, wide: number, unit: number): Place[] {
  const ahead = Math.atan2(out.y, out.x);
  return ROWS.slice(0, 4).flatMap((row) =>
    sides(Math.PI / 6, 5).map((turn) => {
      const far = (OFF + 8 + row * ROW) * unit,
        way = ahead + turn;
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

/** Places of ordinates: of diameters in a column on the right, of positions in two rows below. */
function ordinates(paper: DimensionPaper, { at: p, of }: DimensionOf<"ordinate">, { width, height }: Size): Place[] {
  const { camera, room, unit, free = { x: Infinity, y: Infinity } } = paper,
    { x, y } = toScreen(camera, p);
  if (of === "diameter") {
    const left = Math.max(x + 12 * unit, Math.min(room.x + room.width - width - AIR * unit, free.x));
    return sides((height + unit) / 2, 4).map((by) => ({ x: left + width / 2, y: y + by }));
  }
  const floor = room.y + room.height - AIR * unit,
    top = Math.min(free.y, floor - height);
  return [0, 1].flatMap((row) =>
    sides(width / 2 + unit, 4).map((by) => ({ x: x + by, y: top + height / 2 + row * (height + unit) })),
  );
}

/** Candidate places for the middle of the text of a dimension, the best first. */
function middles(paper: DimensionPaper, figure: Dimension, size: Size): Place[] {
  const { camera, unit } = paper,
    wide = size.width;
  switch (figure.form) {
    case "diameter": {
      const tip = toScreen(camera, figure.at),
        centre = toScreen(camera, at(figure.at.z, 0));
      const up = tip.y - centre.y,
        out = up + Math.sign(up) * OUTSIDE * unit;
      const rows = Math.abs(up) < (TALL + OFF) * unit ? [out, -out] : [0.5, 0.28, 0.74, -0.5].map((k) => k * up);
      return sides(wide / 2 + 8 * unit, 5).flatMap((x) => rows.map((y) => ({ x: tip.x + x, y: centre.y + y })));
    }
    case "circle":
    case "radius":
    case "leader": {
      const [tip, other] = [figure.at, figure.form === "leader" ? figure.towards : figure.centre].map((p) =>
        toScreen(camera, p),
      ) as [Place, Place];
      const side = figure.form === "leader" ? 1 : -1;
      return round(tip, { x: side * (other.x - tip.x), y: side * (other.y - tip.y) }, wide, unit);
    }
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
    case "ordinate":
      return ordinates(paper, figure, size);
    case "z":
    case "r":
    case "along": {
      const places = { z: alongside, r: upright, along: beside }[figure.form];
      return places(toScreen(camera, figure.from), toScreen(camera, figure.to), wide, unit);
    }
  }
}

/** Whether part of what is measured is in the picture: dimensions of other places would crowd its edges. */
function inSight({ camera, size }: DimensionPaper, { measured }: DimensionRequest): boolean {
  const points = "from" in measured && measured.form !== "angle" ? [measured.from, measured.to] : [];
  return [...points, ...("at" in measured ? [measured.at] : []), ...("vertex" in measured ? [measured.vertex] : [])]
    .map((p) => toScreen(camera, p))
    .some(({ x, y }) => x >= 0 && y >= 0 && x <= size.width && y <= size.height);
}

/** Cost of a step to the next candidate, and of each line through a text: it counts before all steps. */
const COST = { step: 3, through: 400 } as const;

/** A text in a box with its lines, which are made only for a box that is free. */
interface DimensionSpot extends Spot {
  readonly draw: () => DrawnDimension;
}

function spotAt(paper: DimensionPaper, { measured }: DimensionRequest, label: LabelBox, cost: number): DimensionSpot {
  let made: DrawnDimension | null = null;
  const draw = () => (made ??= drawnDimension(paper, measured, label));
  return {
    label,
    cost,
    draw,
    get lines() {
      return draw().pieces;
    },
  };
}

function itemOf(paper: DimensionPaper, each: DimensionRequest): Item<DimensionSpot> {
  const size = sizeOf(each, paper);
  const places = each.put ? [toScreen(paper.camera, each.put)] : middles(paper, each.measured, size);
  // The line of an ordinate follows its text, so that one at the edge of the room moves into it.
  const isLed = each.measured.form === "ordinate" && !each.put;
  const boxAt = (p: Place) => (isLed ? movedInto(boxAbout(p, size), paper.room) : boxAbout(p, size));
  return {
    q: each.key,
    needed: each.needed,
    candidates: places.map((p, i) => spotAt(paper, each, boxAt(p), COST.step * i)),
    moved: ({ cost }, label) => spotAt(paper, each, label, cost),
  };
}

/**
 * Places dimensions on a drawing, needed ones first: a text placed by hand stays; each of the others goes where it
 * covers no other text, and of such places to the first with the fewest crossings of lines and texts. Without a free
 * place a needed one takes the place that covers least. Then each is placed once more among all others.
 */
export function placedDimensions(paper: DimensionPaper, asked: readonly DimensionRequest[]): PlacedDimension[] {
  const { size, room, avoid = [], kept } = paper,
    sheet = { ...size, room, avoid, kept, through: COST.through };
  const shown = asked
    .filter((each) => each.needed || inSight(paper, each))
    .toSorted((a, b) => Number(b.needed) - Number(a.needed));
  const items = (isPut: boolean) =>
    shown.filter(({ put }) => isPut === (put !== undefined)).map((each) => itemOf(paper, each));
  const put = items(true).flatMap((item) => item.candidates.map((c) => ({ ...c, item, q: item.q }))),
    free = items(false);
  let placed: readonly Placed<DimensionSpot>[] = arrange(free, sheet, put);
  for (const item of free) {
    const others = placed.filter((p) => p.item !== item);
    if (others.length < placed.length) placed = arrange([item], sheet, others);
  }
  return shown.flatMap(({ key }) => {
    const found = placed.find(({ q }) => q === key);
    return found ? [{ key, box: found.label, ...found.draw() }] : [];
  });
}
