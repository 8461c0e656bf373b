import type { Dimension } from "../../cycles/define.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { boundsOf } from "../bounds.ts";
import { toScreen, type Bounds, type Camera, type Place, type Size } from "../camera.ts";
import { pointAt, type HelpFrame } from "./frame.ts";
import type { LabelBox } from "../dimensions/labels.ts";
import { endWays, type DrawnExtent } from "./section.ts";
import { STEP } from "../../kernel/units.ts";

/** The layout: the camera, the drawing's box on the screen and the spindle axis. */
export interface Layout {
  readonly camera: Camera;
  readonly size: Size;
  /** The drawing without its dimensions, pixels. */
  readonly box: LabelBox;
  /** Where the contour begins and ends across the screen, pixels. */
  readonly contour: { readonly left: number; readonly right: number };
  /** Height of the spindle axis on the screen, pixels; with `broken` the axis is drawn nearer than to scale. */
  readonly axisY: number;
  readonly broken: boolean;
  /** Part space that the drawing shows, mm. */
  readonly reach: DrawnExtent;
}

/** Distance between two dimension lines, pixels. */
export const TRACK = 19;
/** From the drawing to the first dimension line, pixels. */
export const FIRST = 15;

/** Up to this distance from the contour, in contour sizes, the axis is drawn to scale. */
const NEAR_AXIS = 1.6;
/**
 * From this distance on, in contour sizes, the axis may be drawn nearer, if that enlarges the drawing by at least this
 * factor.
 */
const WORTH = { distance: 0.45, factor: 1.3 } as const;
/** Distance of a nearer axis, and of the end of the part, below the contour, in contour sizes. */
const NEARER = { axis: 0.36, part: 0.22 } as const;
/** How far the part continues behind the contour, in contour sizes. */
const BEHIND = 0.16;
/** A dimension's far end is drawn where it is up to this many contour sizes away; farther ones end at the edge. */
const NEAR_DATUM = 0.9;

/** Bounds of contour and dimensions, without far datums. */
function subject(points: readonly Pt[], dimensions: readonly Dimension[]): { core: Bounds; span: number } {
  const core = boundsOf(points) ?? { left: -50, right: 0, low: 0, high: 25 };
  const span = Math.max(core.right - core.left, core.high - core.low, STEP);
  const near = dimensions
    .flatMap((d) => (d.form === "z" ? [d.from, d.to] : []))
    .filter((p) => p.z > core.left - NEAR_DATUM * span && p.z < core.right + NEAR_DATUM * span);
  const wide = boundsOf([...points, ...near.map((p) => ({ ...p, r: points[0]?.r ?? p.r }))]) ?? core;
  return { core: wide, span };
}

/** The area of part space that the drawing shows. */
function reachOf(
  f: HelpFrame,
  line: readonly Pt[],
  core: Bounds,
  span: number,
  nearer: boolean,
): DrawnExtent & { axis: number; broken: boolean } {
  const ends = endWays(f, line);
  const ways = [
    pointAt(f, 0, -1),
    ...(ends.last === "feed" ? [pointAt(f, 1, 0)] : []),
    ...(ends.first === "back" ? [pointAt(f, -1, 0)] : []),
  ];
  const more = (z: number, r: number) =>
    ways.some((w) => Math.abs(w.z - z) + Math.abs(w.r - r) < 0.5) ? BEHIND * span : 0.02 * span;
  const axis = nearer ? core.low - NEARER.axis * span : 0;
  const low = nearer ? core.low - NEARER.part * span : Math.min(0, core.low);
  return {
    left: core.left - more(-1, 0),
    right: core.right + more(1, 0),
    low,
    high: core.high + more(0, 1),
    axis,
    broken: nearer,
  };
}

/** Number of dimension lines on each side of the drawing, from the forms of the dimensions. */
function tracks(dimensions: readonly Dimension[], more: { readonly top: number; readonly right: number }) {
  const count = (form: Dimension["form"]) => dimensions.filter((d) => d.form === form).length;
  return {
    top: Math.min(3, Math.max(1, count("z") + more.top)),
    right: Math.min(3, Math.max(1, count("diameter") + more.right)),
  };
}

/** Fits contour, part and dimension lines into a picture; the scale is the same both ways. */
export function layoutOf(
  f: HelpFrame,
  line: readonly Pt[],
  points: readonly Pt[],
  dimensions: readonly Dimension[],
  size: Size,
  more: { readonly top: number; readonly right: number; readonly indent: number },
): Layout {
  const { core, span } = subject(points, dimensions);
  const zs = line.map((p) => p.z);
  const fit = (nearer: boolean): Layout => {
    const fitted = fitting(reachOf(f, line, core, span, nearer), dimensions, size, more);
    const across = (z: number) => toScreen(fitted.camera, at(z, 0)).x;
    return { ...fitted, contour: { left: across(Math.min(...zs)), right: across(Math.max(...zs)) } };
  };
  if (core.low > NEAR_AXIS * span) return fit(true);
  const real = fit(false);
  if (core.low < WORTH.distance * span) return real;
  const nearer = fit(true);
  return nearer.camera.scale > WORTH.factor * real.camera.scale ? nearer : real;
}

function fitting(
  reach: ReturnType<typeof reachOf>,
  dimensions: readonly Dimension[],
  size: Size,
  more: { readonly top: number; readonly right: number; readonly indent: number },
): Omit<Layout, "contour"> {
  const lines = tracks(dimensions, more);
  const margin = {
    top: Math.min(FIRST + TRACK * lines.top, size.height * 0.35),
    bottom: Math.min(22, size.height * 0.14),
    left: more.indent + Math.min(FIRST + TRACK * (lines.right > 1 ? 1.4 : 1), size.width * 0.25),
    right: Math.min(FIRST + TRACK * lines.right, size.width * 0.25),
  };
  const low = Math.min(reach.axis, reach.low);
  const wide = Math.max(1, size.width - margin.left - margin.right),
    tall = Math.max(1, size.height - margin.top - margin.bottom);
  const scale = Math.min(wide / (reach.right - reach.left), tall / (reach.high - low));
  const spare = { x: wide - scale * (reach.right - reach.left), y: tall - scale * (reach.high - low) };
  const camera: Camera = {
    scale,
    xUp: true,
    zero: { x: margin.left + spare.x / 2 - reach.left * scale, y: margin.top + spare.y / 2 + reach.high * scale },
  };
  const from = toScreen(camera, at(reach.left, reach.high));
  const to = toScreen(camera, at(reach.right, low));
  return {
    camera,
    size,
    reach,
    broken: reach.broken,
    box: { x: from.x, y: from.y, width: to.x - from.x, height: to.y - from.y },
    axisY: toScreen(camera, at(0, reach.axis)).y,
  };
}

/** A part point on the screen, kept inside the picture. */
export function spot(layout: Layout, p: Pt): Place {
  const { x, y } = toScreen(layout.camera, p);
  return { x: Math.min(layout.size.width - 2, Math.max(2, x)), y: Math.min(layout.size.height - 2, Math.max(2, y)) };
}
