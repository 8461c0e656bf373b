import type { Pt } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";
import { JOINED } from "../kernel/tolerance.ts";

/** A place on the screen, CSS pixels from the top left corner of the picture. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A picture's size, CSS pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A box in part space, mm. */
export interface Bounds {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

/** How part space lies on the screen: Z always to the right, X up or down. */
export interface Camera {
  /** Pixels per mm. */
  readonly scale: number;
  /** Where the zero point (z = 0 on the spindle axis) lies, pixels. */
  readonly zero: Place;
  readonly xUp: boolean;
}

/** Useful range of scales for the drawing of a turned part, pixels per mm. */
export const SCALE = { min: 0.05, max: 2000 } as const;

const sign = (camera: Camera) => (camera.xUp ? -1 : 1);

/** Part space to screen. */
export const toScreen = (camera: Camera, p: Pt): Place => ({
  x: camera.zero.x + p.z * camera.scale,
  y: camera.zero.y + sign(camera) * p.r * camera.scale,
});

/** Screen to part space; r is negative on the far side of the axis. */
export const toPlace = (camera: Camera, place: Place): Pt => ({
  z: axial((place.x - camera.zero.x) / camera.scale),
  r: radius((sign(camera) * (place.y - camera.zero.y)) / camera.scale),
});

/** The same map as the six numbers of an SVG matrix, from (z, r) to (x, y). */
export const matrix = (camera: Camera): readonly [number, number, number, number, number, number] => [
  camera.scale,
  0,
  0,
  sign(camera) * camera.scale,
  camera.zero.x,
  camera.zero.y,
];

/** Moves the picture by so many pixels. */
export const panned = (camera: Camera, dx: number, dy: number): Camera => ({
  ...camera,
  zero: { x: camera.zero.x + dx, y: camera.zero.y + dy },
});

/** Zooms by a factor; the point under `at` keeps its place. */
export function zoomed(camera: Camera, factor: number, at: Place): Camera {
  const scale = Math.min(SCALE.max, Math.max(SCALE.min, camera.scale * factor));
  const real = scale / camera.scale;
  return {
    ...camera,
    scale,
    zero: { x: at.x + (camera.zero.x - at.x) * real, y: at.y + (camera.zero.y - at.y) * real },
  };
}

/**
 * Transform that puts a drawing made for one camera under another: scale by a factor from the picture's corner, then
 * shift, pixels.
 */
export function sheetShift(
  drawn: Camera,
  now: Camera,
): { readonly x: number; readonly y: number; readonly grown: number } {
  const grown = now.scale / drawn.scale;
  return { x: now.zero.x - drawn.zero.x * grown, y: now.zero.y - drawn.zero.y * grown, grown };
}

/**
 * The corners of what a camera shows, in the coordinates of a drawing made for another camera, and the scale factor of
 * that drawing there.
 */
export function seenFrom(
  drawn: Camera,
  now: Camera,
  { width, height }: Size,
): { readonly from: Place; readonly to: Place; readonly grown: number } {
  const { x, y, grown } = sheetShift(drawn, now);
  return { from: { x: -x / grown, y: -y / grown }, to: { x: (width - x) / grown, y: (height - y) / grown }, grown };
}

/** Two fingers: the points under both follow (their mean moves, their distance scales). */
export function pinched(camera: Camera, before: readonly [Place, Place], after: readonly [Place, Place]): Camera {
  const mean = ([a, b]: readonly [Place, Place]): Place => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
  const apart = ([a, b]: readonly [Place, Place]) => Math.hypot(a.x - b.x, a.y - b.y);
  const from = mean(before),
    to = mean(after);
  return zoomed(panned(camera, to.x - from.x, to.y - from.y), apart(before) > 0 ? apart(after) / apart(before) : 1, to);
}

/** Turns the picture over at the spindle axis, which stays where it is in the mirrored picture. */
export const turnedOver = (camera: Camera, size: Size): Camera => ({
  ...camera,
  xUp: !camera.xUp,
  zero: { x: camera.zero.x, y: size.height - camera.zero.y },
});

/** Free pixels round a fitted picture. */
export interface Margin {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The camera that shows a box as large as the picture and its margins allow, centred. */
export function fitted(bounds: Bounds, size: Size, margin: Margin, xUp: boolean): Camera {
  const width = Math.max(1, size.width - margin.left - margin.right);
  const height = Math.max(1, size.height - margin.top - margin.bottom);
  const wide = Math.max(JOINED, bounds.right - bounds.left),
    tall = Math.max(JOINED, bounds.high - bounds.low);
  const scale = Math.min(SCALE.max, Math.max(SCALE.min, Math.min(width / wide, height / tall)));
  const middle = { z: (bounds.left + bounds.right) / 2, r: (bounds.low + bounds.high) / 2 };
  return {
    scale,
    xUp,
    zero: {
      x: margin.left + width / 2 - middle.z * scale,
      y: margin.top + height / 2 + (xUp ? 1 : -1) * middle.r * scale,
    },
  };
}
