import type { Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Camera } from "../camera.ts";
import { paintMaterial, type Material } from "./paint.ts";
import { asPage, type Easel } from "./easel.ts";
import type { Patch, Pen } from "./pen.ts";
import { UNTOUCHED, type Surfaces } from "./surfaces.ts";
import { patchWithin, touchedBetween, turnedPatchOf } from "./touched.ts";

/** A run whose stock is painted. */
export interface PaintedRun {
  readonly steps: readonly Step[];
  /** The same rings as long as nothing is cut. */
  readonly stockAt: (position: PlayPosition) => readonly Ring[];
  /** False when the program states another blank between two positions. */
  readonly isSameBlank: (one: PlayPosition, other: PlayPosition) => boolean;
  /** What made the surfaces of the stock. */
  readonly surfaces: Surfaces;
}

/**
 * How a stock is looked at: `origin` is the part of the picture that is painted on, `ground` the one that shows what
 * stands there without the work, `room` all of it that can be seen.
 */
export interface StockLook extends Pick<Material, "section" | "chuck">, Pick<Easel, "colours" | "ratio"> {
  readonly camera: Camera;
  readonly origin: Patch;
  readonly ground: Patch;
  readonly room: Patch;
}

/** Paints the stock of a run at one moment after the other, and of the later ones only what differs. */
export interface StockPainter {
  /** Goes to another moment without painting. */
  readonly goTo: (position: PlayPosition) => void;
  /** The moment, and the stock at it. */
  readonly at: () => PlayPosition;
  readonly rings: () => readonly Ring[];
  /** Paints all of it as it is at the moment. */
  readonly all: (pen: Pen, look: StockLook) => void;
  /** Goes to another moment and paints what looks different there; false when nothing does. */
  readonly follow: (pen: Pen, look: StockLook, position: PlayPosition) => boolean;
}

/** A blank that nothing moves at. */
export const untouchedRun = (blank: readonly Ring[]): PaintedRun => ({
  steps: [],
  stockAt: () => blank,
  isSameBlank: () => true,
  surfaces: UNTOUCHED,
});

/**
 * Paints what stands there without the work on a pen for the ground of a look, and leaves out where the work is
 * painted.
 */
export function paintShop(pen: Pen, look: StockLook): void {
  const onGround = { ...look, origin: look.ground },
    { x, y, width, height } = look.origin;
  stockPainter(untouchedRun([])).all(pen, onGround);
  asPage({ pen, ...onGround });
  pen.clearRect(x, y, width, height);
}

/** How far from the axis there is material, mm. */
export const farthest = (rings: readonly Ring[]): number =>
  rings.reduce((most, ring) => ring.reduce((far, p) => Math.max(far, p.r), most), 0);

/** Whether nothing but rapids runs between two positions: they leave surfaces as they are. */
const onlyRapids = (steps: readonly Step[], one: PlayPosition, other: PlayPosition) =>
  steps
    .slice(Math.min(one.step, other.step), Math.max(one.step, other.step) + 1)
    .every((step) => step.move.kind === "rapid");

/** A painter that stands at the start of a run. */
export function stockPainter({ steps, stockAt, isSameBlank, surfaces }: PaintedRun): StockPainter {
  let now: PlayPosition = { step: 0, fraction: 0 };
  let rings = stockAt(now);
  const goTo = (position: PlayPosition) => {
    now = position;
    rings = stockAt(position);
  };
  const paint = (pen: Pen, { section, chuck, camera, ...look }: StockLook, patch: Patch) =>
    paintMaterial(pen, { rings, section, now, surfaces, chuck }, camera, look, patch);
  return {
    goTo,
    at: () => now,
    rings: () => rings,
    all: (pen, look) => paint(pen, look, look.origin),
    follow(pen, look, position) {
      const [before, were] = [now, rings];
      goTo(position);
      if (rings === were && onlyRapids(steps, before, now)) return false;
      const touched = isSameBlank(before, now) ? touchedBetween(steps, before, now) : "all";
      if (!touched) return false;
      if (touched === "all") paint(pen, look, look.origin);
      else {
        const reach = { outer: Math.max(farthest(were), farthest(rings)), along: surfaces.lead(now) };
        const patch = patchWithin(turnedPatchOf(touched, look.camera, reach, look.ratio), look.room);
        if (patch) paint(pen, look, patch);
      }
      return true;
    },
  };
}
