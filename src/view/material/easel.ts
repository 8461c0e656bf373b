import type { Camera, Place } from "../camera.ts";
import type { Pen } from "./pen.ts";
import { shadeStops, slopeNumber, slopeOf, type Facing } from "./shade.ts";
import type { Texture } from "./surfaces.ts";

/**
 * How the work is looked at: cut above the axis and whole below it, cut on both sides, or whole. The cut lies on the
 * tool's side.
 */
export type SectionKind = "half" | "full" | "outside";

/** What the material is painted with, as CSS colours; those of steel and chuck as `#rrggbb`. */
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

/** Where a painter works: on what, how it lies there, and with which colours. */
export interface Easel {
  readonly pen: Pen;
  readonly camera: Camera;
  readonly colours: MaterialColours;
  /** Pixels of the device for one of the page. */
  readonly ratio: number;
  /** Where the corner of the canvas lies in the picture. */
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

/** Back to the pixels of the page. */
export const asPage = ({ pen, ratio, origin: { x, y } }: Easel): void =>
  pen.setTransform(ratio, 0, 0, ratio, -x * ratio, -y * ratio);

/** What is shaded: steel that is worked on, or the chuck. */
export type Body = "steel" | "chuck";

/** Gradients that a pen has made already, for the colours they were made with. */
const brushes = new WeakMap<Pen, { readonly colours: MaterialColours; readonly made: Map<string, object> }>();

/** A brush for the shade across a radius, from 0 at the axis to 1 at the edge along y. */
export function brush({ pen, colours }: Easel, body: Body, slope: number, texture: Texture, facing: Facing): object {
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

/** Lays a shade across the radius: y counts from the axis, 1 is `r` mm from it on one side of the picture. */
export function acrossRadius({ pen, camera, ratio, origin }: Easel, down: 1 | -1, r: number): void {
  pen.setTransform(ratio, 0, 0, ratio * down * r * camera.scale, -origin.x * ratio, ratio * (camera.zero.y - origin.y));
}

/** Begins a way through places of one half, mm, distances from the axis positive. */
export function trace(
  { pen, camera: { scale, zero } }: Easel,
  down: 1 | -1,
  places: readonly (readonly [z: number, r: number])[],
): void {
  places.forEach(([z, r], i) => {
    const [x, y] = [zero.x + z * scale, zero.y + down * r * scale];
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
}
