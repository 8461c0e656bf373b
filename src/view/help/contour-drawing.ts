import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radians, toRadius } from "../../kernel/units.ts";
import { boundsOf } from "../bounds.ts";
import { fitted, toPlace, toScreen, type Camera, type Margin, type Place, type Size } from "../camera.ts";
import { arrange, type Spot } from "../dimensions/arrange.ts";
import { textBox, type LabelBox } from "../dimensions/labels.ts";
import { polyline, px, segmentPath } from "./marks.ts";
import { drawnLine } from "./section.ts";
import { SAME } from "../../kernel/tolerance.ts";

const { pointOn } = part;

/** Input of the drawing beside the contour table. */
export interface ContourRequest {
  readonly contour: readonly Segment[];
  readonly rowOfSegment: readonly number[];
  /** Where each row ends (X as diameter), or null. */
  readonly ends: readonly ({ readonly x: number; readonly z: number } | null)[];
  readonly faulty: ReadonlySet<number>;
  readonly active: number | null;
  readonly size: Size;
  /** The camera; without one the contour fills the drawing. */
  readonly camera?: Camera | null;
  /** Margin round a contour that fills the drawing. */
  readonly margin?: Margin;
  readonly xUp?: boolean;
  /** What the drawing shows beside the contour: the blank. */
  readonly beside?: readonly Pt[];
  /** Distance of grid lines, mm on the radius and along Z; none without it. */
  readonly grid?: ((scale: number) => { readonly z: number; readonly r: number }) | null;
}

/** The drawing as data: elements by row, numbered points, spindle axis; CSS pixels. */
export interface ContourPicture {
  readonly camera: Camera;
  readonly grid: string;
  readonly axis: string;
  readonly elements: readonly { readonly row: number; readonly d: string; readonly faulty: boolean }[];
  readonly points: readonly {
    readonly row: number;
    readonly place: Place;
    readonly label: Place | null;
    readonly faulty: boolean;
  }[];
  /** Points along the contour that other texts should avoid, and the boxes of points and numbers, which they must avoid. */
  readonly avoid: readonly Place[];
  readonly kept: readonly LabelBox[];
}

const MARGIN: Margin = { left: 26, right: 26, top: 22, bottom: 22 };
/** Beyond this distance, in contour sizes, the axis is left out, so that the contour stays large. */
const NEAR_AXIS = 2;

function cameraFor(points: readonly Pt[], size: Size, margin: Margin, xUp: boolean): Camera {
  const all = boundsOf(points) ?? { left: -50, right: 5, low: 0, high: 40 };
  const span = Math.max(all.right - all.left, all.high - all.low, 1);
  const low = all.low < NEAR_AXIS * span ? Math.min(0, all.low) : all.low;
  const box =
    all.right - all.left + all.high - low < SAME
      ? { left: all.left - 10, right: all.right + 10, low: 0, high: all.high + 10 }
      : { ...all, low };
  const camera = fitted(box, size, margin, xUp),
    free = size.height - margin.top - margin.bottom - (box.high - box.low) * camera.scale;
  // Nothing is drawn beyond the axis, so most of the free height is on the side of the contour.
  const down = box.low === 0 ? (0.5 - BEYOND_AXIS) * Math.max(0, free) * (xUp ? 1 : -1) : 0;
  return { ...camera, zero: { x: camera.zero.x, y: camera.zero.y + down } };
}

/** Share of the free height that lies beyond the axis. */
const BEYOND_AXIS = 0.2;

/** How much of the surroundings is shown round the contour, as a share of its size. */
const ROUND_ABOUT = 0.2;

/** A contour with fewer points has no size yet from which to choose the scale. */
const FEW = 3;

/** The surrounding points, moved close enough to widen the picture only so far. */
function nearby(points: readonly Pt[], beside: readonly Pt[]): readonly Pt[] {
  const own = boundsOf(points);
  if (!own || points.length < FEW) return beside;
  const by = ROUND_ABOUT * Math.max(own.right - own.left, own.high - own.low);
  const between = (low: number, n: number, high: number) => Math.max(low, Math.min(n, high));
  return beside.map((p) =>
    part.point(between(own.left - by, p.z, own.right + by), between(own.low - by, p.r, own.high + by)),
  );
}

/** Half the size of a point, and of the middle of a rounding or a chamfer, with their lines, pixels. */
const DOT = 5.5,
  CORNER = 3.5;

function dotBox({ x, y }: Place, isCorner: boolean): LabelBox {
  const half = isCorner ? CORNER : DOT;
  return { x: x - half, y: y - half, width: 2 * half, height: 2 * half };
}

/** Directions from a point to its number, the best first: dimension lines run straight down and to the right. */
const WAYS = [-45, -135, 135, 45, -90, 180, 0, 90] as const;

/** Candidate places for a number beside its point. */
const numberSpots = (at: Place, text: string, isFaulty: boolean): Spot[] =>
  (isFaulty ? [20, 27] : [16, 20, 26]).flatMap((reach) =>
    WAYS.map((degrees, k) => {
      const way = radians(degrees),
        middle = { x: at.x + reach * Math.cos(way), y: at.y + reach * Math.sin(way) };
      return { label: textBox(middle, text, 0, 12), lines: [], cost: (reach + k) / 5 };
    }),
  );

/** Most grid lines in one direction. */
const MOST_LINES = 300;

/** Grid lines at whole multiples of a distance, over the whole drawing. */
function gridPath(camera: Camera, size: Size, step: { readonly z: number; readonly r: number }): string {
  const [left, right] = [toPlace(camera, { x: 0, y: size.height }), toPlace(camera, { x: size.width, y: 0 })];
  const [low, high] = [
    { z: left.z, r: Math.min(left.r, right.r) },
    { z: right.z, r: Math.max(left.r, right.r) },
  ];
  const multiples = (from: number, to: number, by: number) => {
    const first = Math.ceil(from / by),
      count = Math.floor(to / by) - first + 1;
    return count > MOST_LINES ? [] : Array.from({ length: Math.max(0, count) }, (_, i) => (first + i) * by);
  };
  const upright = multiples(low.z, high.z, step.z).map((z) => toScreen(camera, part.point(z, 0)).x);
  const level = multiples(low.r, high.r, step.r).map((r) => toScreen(camera, part.point(0, r)).y);
  return [
    ...upright.map((x) => `M${px(x)} 0V${px(size.height)}`),
    ...level.map((y) => `M0 ${px(y)}H${px(size.width)}`),
  ].join("");
}

/**
 * Approximate limit of points that texts avoid along a contour: the many elements of a long one are short on the
 * screen.
 */
const MOST_PLACES = 4800;

/** Draws the contour of a table as data. */
export function contourDrawing(request: ContourRequest): ContourPicture {
  const {
    contour,
    rowOfSegment,
    ends,
    faulty,
    active,
    size,
    camera: given,
    grid,
    margin = MARGIN,
    xUp = true,
    beside = [],
  } = request;
  const stops = ends.flatMap((e, row) => (e ? [{ row, at: { z: axial(e.z), r: toRadius(diameter(e.x)) } }] : []));
  const shown = [...drawnLine(contour), ...stops.map((s) => s.at)];
  const camera = given ?? cameraFor([...shown, ...nearby(shown, beside)], size, margin, xUp);
  const rows = new Map<number, { readonly first: number; readonly own: Segment[] }>();
  contour.forEach((s, i) => {
    const row = rowOfSegment[i] ?? 0,
      known = rows.get(row);
    if (known) known.own.push(s);
    else rows.set(row, { first: i, own: [s] });
  });
  const elements = [...rows].map(([row, { own }]) => ({ row, faulty: faulty.has(row), d: segmentPath(own, camera) }));
  const corners = contour.flatMap((s, i) => {
    const row = rowOfSegment[i] ?? 0;
    // A recess has many segments but one number.
    return ends[row] === null && rows.get(row)?.first === i ? [{ row, at: pointOn(s, 0.5) }] : [];
  });
  const drawnRows = new Set([...stops, ...corners].map((s) => s.row));
  const missing = [...faulty]
    .filter((row) => !drawnRows.has(row))
    .flatMap((row) => {
      const before = stops.filter((s) => s.row < row).at(-1) ?? stops[0];
      return before ? [{ row, at: before.at }] : [];
    });
  const each = Math.max(2, Math.min(24, Math.ceil(MOST_PLACES / contour.length)));
  const avoid = contour.flatMap((s) => Array.from({ length: each }, (_, k) => toScreen(camera, pointOn(s, k / each))));
  const isCorner = new Set(corners.map(({ row }) => row)),
    dots = [...stops, ...corners].map(({ row, at }) => dotBox(toScreen(camera, at), isCorner.has(row)));
  const marks = [...stops, ...corners, ...missing].sort(
    (a, b) => Number(b.row === active) - Number(a.row === active) || a.row - b.row,
  );
  const numbers = arrange(
    marks.map(({ row, at }) => {
      const text = faulty.has(row) ? `${row + 1}!` : String(row + 1);
      return { q: String(row), candidates: numberSpots(toScreen(camera, at), text, faulty.has(row)) };
    }),
    { ...size, avoid, kept: dots },
  );
  const points = marks.map(({ row, at }) => {
    const box = numbers.find(({ q }) => q === String(row))?.label,
      label = box ? { x: box.x + box.width / 2, y: box.y + box.height / 2 } : null;
    return { row, place: toScreen(camera, at), label, faulty: faulty.has(row) };
  });
  const y = toScreen(camera, part.point(0, 0)).y;
  return {
    camera,
    grid: grid ? gridPath(camera, size, grid(camera.scale)) : "",
    axis:
      y > 0 && y < size.height
        ? polyline([
            { x: 4, y },
            { x: size.width - 4, y },
          ])
        : "",
    elements,
    points,
    avoid,
    kept: [...dots, ...numbers.map(({ label }) => label)],
  };
}
