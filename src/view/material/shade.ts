import type { Texture } from "./surfaces.ts";

/**
 * Shading of round steel. The work is seen square to its axis; a place on it is given by `u`, its distance from the
 * axis as a share of the radius there (0: it faces the viewer, 1: the edge), and by the slope of its surface along the
 * axis.
 */

/** The colours of a shade, as `#rrggbb`. */
export interface Steel {
  readonly dark: string;
  readonly base: string;
  readonly light: string;
}

/** Which side of a body is seen: the lit half of its outside, the other half, or the wall of a hole behind the cut. */
export type Facing = "lit" | "away" | "hole";

/** The position of the one soft light over the lit half: at a third of the radius. */
const LIGHT = Math.asin(1 / 3);
/** How much of the light comes along the axis, from the free end of the work. */
const ALONG = 0.4;

interface Gloss {
  readonly ground: number;
  readonly shine: number;
  readonly sharp: number;
}
/** A finished surface is light and shines, a rough one is dull, and a raw one is duller. */
const GLOSS: Readonly<Record<Texture, Gloss>> = {
  raw: { ground: 0.44, shine: 0.02, sharp: 8 },
  rough: { ground: 0.52, shine: 0.12, sharp: 12 },
  thread: { ground: 0.54, shine: 0.2, sharp: 16 },
  finished: { ground: 0.6, shine: 0.34, sharp: 26 },
};

/**
 * Lightness 0 … 1 of a place: `slope` is the angle of the surface to the axis, radians, positive if it faces the free
 * end.
 */
export function lightness(u: number, slope: number, texture: Texture, facing: Facing): number {
  const { ground, shine, sharp } = GLOSS[texture];
  const around = Math.asin(Math.min(1, Math.max(0, u)));
  // A hole is seen from within: dark where it is deepest, lighter towards its edge.
  if (facing === "hole")
    return clamped(0.12 + 0.32 * u * u + 0.12 * Math.sin(slope) + (texture === "finished" ? 0.07 : 0));
  const off = facing === "lit" ? around - LIGHT : around + LIGHT,
    towards = Math.max(0, Math.cos(off));
  const diffuse = (towards * Math.cos(slope) + ALONG * Math.sin(slope)) / Math.hypot(1, ALONG);
  return clamped(0.05 + ground * Math.max(0, diffuse) ** 1.4 * 1.15 + shine * towards ** sharp * Math.cos(slope) ** 2);
}

const clamped = (v: number) => Math.min(1, Math.max(0, v));

const channels = (colour: string): readonly number[] =>
  [1, 3, 5].map((i) => Number.parseInt(colour.slice(i, i + 2), 16));

/** A colour between two, `#rrggbb`. */
export function mixed(a: string, b: string, share: number): string {
  const [from, to] = [channels(a), channels(b)];
  return `#${from
    .map((v, i) =>
      Math.round(v + ((to[i] ?? v) - v) * share)
        .toString(16)
        .padStart(2, "0"),
    )
    .join("")}`;
}

/** The colour of a lightness. */
export const steelAt = ({ dark, base, light }: Steel, value: number): string =>
  value < 0.5 ? mixed(dark, base, value * 2) : mixed(base, light, value * 2 - 1);

/** Sample places of a shade, as shares of the radius; the shade is linear between them. */
const STOPS = [0, 0.08, 0.16, 0.24, 0.3, 0.34, 0.4, 0.48, 0.58, 0.68, 0.77, 0.85, 0.91, 0.955, 0.985, 1] as const;

/** The shade across the radius, from the axis to the edge, as stops of a gradient. */
export const shadeStops = (
  steel: Steel,
  slope: number,
  texture: Texture,
  facing: Facing,
): readonly (readonly [number, string])[] =>
  STOPS.map((u) => [u, steelAt(steel, lightness(u, slope, texture, facing))] as const);

/** Surfaces whose slopes differ by less than this have one shade, radians. */
const SLOPES = Math.PI / 90;
/** The number of a slope, and the slope of a number. */
export const slopeNumber = (slope: number) => Math.round(slope / SLOPES);
export const slopeOf = (number: number) => number * SLOPES;
