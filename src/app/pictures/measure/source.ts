import { useMemo } from "react";
import type { MeasuredMoment } from "../../../kernel/plan/measured.ts";
import type { Move } from "../../../kernel/plan/move.ts";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import type { Chain } from "../../../view/measure/edges.ts";
import { stockFingerprints } from "../../../view/measure/stock-fingerprint.ts";
import type { MeasuredWork } from "../../../view/measure/reading.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/**
 * Measurable content of a picture. Measuring knows only this and the viewport. Axes are always z to the right and r up:
 * a milled plane ("XY") gives X as z and Y as r (`partPoint`, `partSegment`), without mirroring, and its diameters are
 * those of circles.
 */
export interface MeasureSource {
  readonly plane: "ZX" | "XY";
  readonly contours: readonly Chain[];
  readonly blank: readonly Ring[];
  /** Ends of moves; called when something is measured. */
  readonly path: () => readonly Pt[];
  /** The shown moment while it rests; null if its stock is not known. */
  readonly moment: () => Omit<MeasuredMoment, "print"> | null;
  /** The stock of that moment. */
  readonly stock: () => readonly Ring[];
  readonly fingerprintOf: MeasuredWork["fingerprintOf"];
}

/** Measurable content of a run in one plane, without the stock of a moment. */
export type MeasurableRun = Pick<MeasureSource, "plane" | "contours" | "blank" | "path" | "fingerprintOf">;

/** The lathe's half plane of a run: contours, and the ends of its motions. */
export const measurableRun = (run: Run): MeasurableRun => ({
  plane: "ZX",
  contours: run.operations.map(({ plan }) => plan.contour),
  blank: run.blank,
  path: () => run.steps.flatMap(({ from, move }, i) => (i === 0 ? [from, move.to] : [move.to])),
  fingerprintOf: stockFingerprints(run),
});

/** The stock of a run at any moment, up to the step that it is cut to. */
export interface MeasuredStock {
  readonly at: (position: PlayPosition) => readonly Ring[];
  readonly reached: () => number;
}

/** A move of the shown path: its block, and its pass in a cycle. */
export interface MeasuredMove {
  readonly block: number;
  readonly move?: Pick<Move, "pass">;
}

/** Measurable content of a picture with the stock of its moment. `stock`: null if not known. */
export function useMeasureSource(
  measurable: MeasurableRun,
  moves: readonly MeasuredMove[],
  stock: MeasuredStock | null,
  playback: PlaybackStore,
): MeasureSource {
  return useMemo(
    () => ({
      ...measurable,
      moment() {
        const {
            position: { step, fraction },
            playing,
          } = playback.get(),
          running = moves[step];
        if (playing || !stock || stock.reached() < step) return null;
        if (!running) return { step: moves.length, fraction: 0 };
        const pass = running.move?.pass;
        return { step, fraction, block: running.block, ...(pass !== undefined && { pass }) };
      },
      stock: () => stock?.at(playback.get().position) ?? [],
    }),
    [measurable, moves, stock, playback],
  );
}
