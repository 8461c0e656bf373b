import type { PlayPosition } from "../../sim/simulation.ts";
import type { Camera } from "../camera.ts";
import type { Patch, Pen } from "./pen.ts";

/** What every painter needs of a view. */
export interface PaintedLook {
  readonly camera: Camera;
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
  /** The painted part of the picture. */
  readonly origin: Patch;
  /** The part that shows the surroundings without the work; null without any. */
  readonly ground: Patch | null;
}

/** Paints a stock at successive moments; later moments repaint only the differences. */
export interface Painter<Look extends PaintedLook> {
  /** Goes to another moment without painting. */
  readonly goTo: (position: PlayPosition) => void;
  readonly at: () => PlayPosition;
  /** What the current moment shows: the same parts in the same view make the same picture. */
  readonly parts: () => readonly unknown[];
  /** Paints everything at the current moment. */
  readonly all: (pen: Pen, look: Look) => void;
  /** Goes to another moment and repaints the differences; false if there are none. */
  readonly follow: (pen: Pen, look: Look, position: PlayPosition) => boolean;
  /** Paints the surroundings onto a pen for the ground, without the area of the work. */
  readonly around: (pen: Pen, look: Look) => void;
}
