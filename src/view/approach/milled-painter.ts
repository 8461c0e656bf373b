import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import type { MilledMoment, MilledStock } from "../../sim/plane/milled.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Camera } from "../camera.ts";
import type { Patch, Pen } from "../material/pen.ts";
import { patchOf, patchWithin } from "../material/touched.ts";
import { paintMilled, type MilledColours } from "./milled-paint.ts";
import { milledBetween } from "./touched-plane.ts";

/** How milled stock is looked at: `origin` is the part of the picture that is painted on. */
export interface MilledLook {
  readonly camera: Camera;
  readonly colours: MilledColours;
  /** The tone of each depth, as a CSS colour. */
  readonly tones: readonly string[];
  /** Pixels of the device for one of the page. */
  readonly ratio: number;
  readonly origin: Patch;
}

/** Paints milled stock at one moment after the other, and of the later ones only what differs. */
export interface MilledPainter {
  /** Goes to another moment without painting. */
  readonly goTo: (position: PlayPosition) => void;
  readonly at: () => PlayPosition;
  /** Paints all of it as it is at the moment. */
  readonly all: (pen: Pen, look: MilledLook) => void;
  /** Goes to another moment and paints what looks different there; false when nothing does. */
  readonly follow: (pen: Pen, look: MilledLook, position: PlayPosition) => boolean;
}

/** A painter that stands at the start of a run. */
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
    all: (pen, look) => paint(pen, look, look.origin),
    follow(pen, look, position) {
      const before = now,
        was = reached;
      goTo(position);
      // What was painted before it was cut as far is another stock than that of its moment.
      const isWhole = was >= before.step && stock.isSameBody(before.step, now.step);
      const touched = isWhole ? milledBetween(motions, before, now) : "all";
      const patch =
        touched === "all"
          ? look.origin
          : touched && patchWithin(patchOf(touched, look.camera, look.ratio), look.origin);
      if (patch) paint(pen, look, patch);
      return patch !== null;
    },
  };
}
