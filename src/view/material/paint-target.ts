import type { Camera, Place } from "../camera.ts";
import type { Pen } from "./pen.ts";
import { shadeStops, slopeNumber, slopeOf, type Facing } from "./shade.ts";
import type { Texture } from "./surfaces.ts";

/**
 * The view of the work: cut above the axis and whole below it, cut on both sides, or whole. The cut is on the tool's
 * side.
 */
export type SectionKind = "half" | "full" | "outside";

/** Colours of the material, as CSS colours; those of steel and chuck as `#rrggbb`. */
export interface MaterialColours {
  readonly ground: string;
  readonly hatch: string;
  readonly edge: string;
  readonly steelDark: string;
  readonly steel: string;
  readonly steelLight: string;
  readonly chuckDark: string;
  readonly chuck: string;
  readonly chuckLight: string;
}

/** Where a painter draws: the pen, the camera and the colours. */
export interface PaintTarget {
  readonly pen: Pen;
  readonly camera: Camera;
  readonly colours: MaterialColours;
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
  /** The corner of the canvas in the picture. */
  readonly origin: Place;
}

/** One half of the picture: the side of the axis, 1 downwards; cut open or seen from outside. */
export interface Half {
  readonly down: 1 | -1;
  readonly isCut: boolean;
  readonly facing: Exclude<Facing, "hole">;
}

/** Both halves, the one on the tool's side first. */
export function halvesOf(section: SectionKind, xUp: boolean): readonly [Half, Half] {
  const tool = xUp ? -1 : 1,
    other = xUp ? 1 : -1;
  if (section === "outside") {
    const lit = (down: 1 | -1): Half => ({ down, isCut: false, facing: down < 0 ? "lit" : "away" });
    return [lit(tool), lit(other)];
  }
  return [
    { down: tool, isCut: true, facing: "away" },
    { down: other, isCut: section === "full", facing: "lit" },
  ];
}

/** Sets the pen to CSS pixels. */
export const asPage = ({ pen, ratio, origin: { x, y } }: PaintTarget): void =>
  pen.setTransform(ratio, 0, 0, ratio, -x * ratio, -y * ratio);

/** The shaded body: the work, or the chuck. */
export type Body = "steel" | "chuck";

/** Cached gradients of a pen, for the colours that they were made with. */
const brushes = new WeakMap<Pen, { readonly colours: MaterialColours; readonly made: Map<string, object> }>();

/** A brush for the shade across a radius, from 0 at the axis to 1 at the edge along y. */
export function brush(
  { pen, colours }: PaintTarget,
  body: Body,
  slope: number,
  texture: Texture,
  facing: Facing,
): object {
  let own = brushes.get(pen);
  if (own?.colours !== colours) {
    own = { colours, made: new Map() };
    brushes.set(pen, own);
  }
  const number = slopeNumber(slope),
    key = `${body} ${number} ${texture} ${facing}`;
  const have = own.made.get(key);
  if (have) return have;
  const gradient = pen.createLinearGradient(0, 0, 0, 1);
  const steel =
    body === "steel"
      ? { dark: colours.steelDark, base: colours.steel, light: colours.steelLight }
      : { dark: colours.chuckDark, base: colours.chuck, light: colours.chuckLight };
  for (const [at, colour] of shadeStops(steel, slopeOf(number), texture, facing)) gradient.addColorStop(at, colour);
  own.made.set(key, gradient);
  return gradient;
}

/**
 * Scales the pen to shade across the radius: y starts at the axis, and 1 is `r` mm from it on one side of the picture.
 */
export function acrossRadius({ pen, camera, ratio, origin }: PaintTarget, down: 1 | -1, r: number): void {
  pen.setTransform(ratio, 0, 0, ratio * down * r * camera.scale, -origin.x * ratio, ratio * (camera.zero.y - origin.y));
}

/** Begins a path through points of one half, mm; distances from the axis are positive. */
export function trace(
  { pen, camera: { scale, zero } }: PaintTarget,
  down: 1 | -1,
  places: readonly (readonly [z: number, r: number])[],
): void {
  places.forEach(([z, r], i) => {
    const [x, y] = [zero.x + z * scale, zero.y + down * r * scale];
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
}
