import { mirrors, toFlat, toPart, type Frame } from "../../kernel/geometry/flat.ts";
import type { Pt } from "../../kernel/geometry/point.ts";

/** The orientation of strategy space in the drawing, and whether the tool goes into a groove. */
export interface HelpFrame extends Frame {
  readonly sunk: boolean;
}

/** Coordinate along the cutting feed. */
export const along = (f: Frame, p: Pt): number => toFlat(f, p).u;
/** Coordinate towards the open side. */
export const outward = (f: Frame, p: Pt): number => toFlat(f, p).v;
/** The point with these two coordinates. */
export const pointAt = (f: Frame, u: number, v: number): Pt => toPart(f, { u, v });
/** How a length along the infeed is dimensioned. */
export const infeedForm = (f: Frame): "z" | "r" => (f.transverse ? "z" : "r");
/** Whether the open side lies to the left (1) or to the right (−1) of the contour. */
export const openSide = (f: Frame): 1 | -1 => (mirrors(f) ? -1 : 1);
