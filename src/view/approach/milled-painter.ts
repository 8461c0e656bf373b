import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import type { MilledMoment, MilledStock } from "../../sim/plane/milled.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { PaintedLook, Painter } from "../material/painter.ts";
import type { Patch, Pen } from "../material/pen.ts";
import { patchOf, patchWithin } from "../material/changed-box.ts";
import { paintMilled, type MilledColours } from "./milled-paint.ts";
import { changedPlaneBox } from "./changed-box.ts";

/** View settings of milled stock. */
export interface MilledLook extends PaintedLook {
  readonly colours: MilledColours;
  /** The tone of each depth, as a CSS colour. */
  readonly tones: readonly string[];
}

/** A painter at the start of a run. */
export function milledPainter(
  motions: readonly MillMotion[],
  stock: Pick<MilledStock, "at" | "isSameBody" | "reached">,
): Painter<MilledLook> {
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
    parts: () => [stock, now.step, now.fraction, reached],
    around: () => undefined,
    all: (pen, look) => paint(pen, look, look.origin),
    follow(pen, look, position) {
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
