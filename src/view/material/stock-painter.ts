import type { Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { paintMaterial, type Material } from "./paint.ts";
import { asPage, type PaintTarget } from "./paint-target.ts";
import type { PaintedLook, Painter } from "./painter.ts";
import type { Patch, Pen } from "./pen.ts";
import { UNTOUCHED, type Surfaces } from "./surfaces.ts";
import { patchWithin, changedBox, turnedPatchOf } from "./changed-box.ts";

/** A run whose stock is painted. */
export interface PaintedRun {
  readonly steps: readonly Step[];
  /** Returns the same rings as long as nothing is cut. */
  readonly stockAt: (position: PlayPosition) => readonly Ring[];
  /** False when the program states another blank between two positions. */
  readonly isSameBlank: (one: PlayPosition, other: PlayPosition) => boolean;
  /** The origin of the stock's surfaces. */
  readonly surfaces: Surfaces;
}

/** View settings of a stock: `room` is everything visible. */
export interface StockLook
  extends PaintedLook, Pick<Material, "section" | "chuck">, Pick<PaintTarget, "colours" | "ratio"> {
  readonly room: Patch;
}

/** A run of a blank without any move. */
export const untouchedRun = (blank: readonly Ring[]): PaintedRun => ({
  steps: [],
  stockAt: () => blank,
  isSameBlank: () => true,
  surfaces: UNTOUCHED,
});

/** Paints only the surroundings, and leaves out the area where the work is painted. */
function paintSurroundings(pen: Pen, look: StockLook): void {
  if (!look.ground) return;
  const onGround = { ...look, origin: look.ground },
    { x, y, width, height } = look.origin;
  stockPainter(untouchedRun([])).all(pen, onGround);
  asPage({ pen, ...onGround });
  pen.clearRect(x, y, width, height);
}

/** Largest radius with material, mm. */
export const farthest = (rings: readonly Ring[]): number =>
  rings.reduce((most, ring) => ring.reduce((far, p) => Math.max(far, p.r), most), 0);

/** Whether only rapids run between two positions: they leave surfaces unchanged. */
const onlyRapids = (steps: readonly Step[], one: PlayPosition, other: PlayPosition) =>
  steps
    .slice(Math.min(one.step, other.step), Math.max(one.step, other.step) + 1)
    .every((step) => step.move.kind === "rapid");

/** A painter at the start of a run. */
export function stockPainter({ steps, stockAt, isSameBlank, surfaces }: PaintedRun): Painter<StockLook> {
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
    parts: () => [rings, surfaces],
    around: paintSurroundings,
    all: (pen, look) => paint(pen, look, look.origin),
    follow(pen, look, position) {
      const [before, were] = [now, rings];
      goTo(position);
      if (rings === were && onlyRapids(steps, before, now)) return false;
      const touched = isSameBlank(before, now) ? changedBox(steps, before, now) : "all";
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
