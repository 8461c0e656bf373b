import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import type { MilledMoment, MilledStock } from "../../sim/plane/milled.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Camera } from "../camera.ts";
import type { Patch, Pen } from "../material/pen.ts";
import { patchOf, patchWithin } from "../material/changed-box.ts";
import { paintMilled, type MilledColours } from "./milled-paint.ts";
import { changedPlaneBox } from "./changed-box.ts";

/** View settings of milled stock: `origin` is the painted part of the picture. */
export interface MilledLook {
  readonly camera: Camera;
  readonly colours: MilledColours;
  /** The tone of each depth, as a CSS colour. */
  readonly tones: readonly string[];
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
  readonly origin: Patch;
}

/** Paints milled stock at successive moments; later moments repaint only the differences. */
export interface MilledPainter {
  /** Goes to another moment without painting. */
  readonly goTo: (position: PlayPosition) => void;
  readonly at: () => PlayPosition;
  /** Paints everything at the current moment. */
  readonly paintAll: (pen: Pen, look: MilledLook) => void;
  /** Goes to another moment and repaints the differences; false if there are none. */
  readonly paintChanges: (pen: Pen, look: MilledLook, position: PlayPosition) => boolean;
}

/** A painter at the start of a run. */
export function milledPainter(
  motions: readonly MillMotion[],
  stock: Pick<MilledStock, "at" | "isSameBody" | "reached">,
): MilledPainter {
  let now: PlayPosition = { step: 0, fraction: 0 },
    moment: MilledMoment | null = null,
    reached = 0;
  const goTo = (position: PlayPosition) => {
    [now, moment, reached] = [position, null, stock.reached()];
  };
  const paint = (pen: Pen, { camera, colours, tones, ratio, origin }: MilledLook, patch: Patch) => {
    moment ??= stock.at(now);
    pen.setTransform(ratio, 0, 0, ratio, -origin.x * ratio, -origin.y * ratio);
    paintMilled(pen, { moment, tones }, camera, colours, patch);
  };
  return {
    goTo,
    at: () => now,
    paintAll: (pen, look) => paint(pen, look, look.origin),
    paintChanges(pen, look, position) {
      const before = now,
        was = reached;
      goTo(position);
      // A picture painted before the stock was cut up to its moment is outdated.
      const isWhole = was >= before.step && stock.isSameBody(before.step, now.step);
      const touched = isWhole ? changedPlaneBox(motions, before, now) : "all";
      const patch =
        touched === "all"
          ? look.origin
          : touched && patchWithin(patchOf(touched, look.camera, look.ratio), look.origin);
      if (patch) paint(pen, look, patch);
      return patch !== null;
    },
  };
}
