import { useMemo } from "react";
import type { MeasuredMoment } from "../../../kernel/plan/measured.ts";
import type { Pt, Ring } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import type { Chain } from "../../../view/measure/edges.ts";
import { printsOf } from "../../../view/measure/print.ts";
import type { MeasuredWork } from "../../../view/measure/reading.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/**
 * What a picture has to measure. The pieces of measuring know no more of a picture than this and its viewport: the two
 * axes are z to the right and r upwards, whatever they are called. A milled plane ("XY") gives X as z and Y as r
 * (`partPoint`, `partSegment`); in it nothing is mirrored and a diameter is that of a circle.
 */
export interface MeasureSource {
  readonly plane: "ZX" | "XY";
  readonly contours: readonly Chain[];
  readonly blank: readonly Ring[];
  /** Ends of moves; asked for when something is measured. */
  readonly path: () => readonly Pt[];
  /** The moment that is shown, as long as it rests; null where its stock is not known. */
  readonly moment: () => Omit<MeasuredMoment, "print"> | null;
  /** The stock of that moment. */
  readonly stock: () => readonly Ring[];
  readonly printOf: MeasuredWork["printOf"];
}

/** What a run has to measure in one of its planes, without the stock of a moment. */
export type MeasurableRun = Pick<MeasureSource, "plane" | "contours" | "blank" | "path" | "printOf">;

/** The lathe's half plane of a run: contours, and the ends of its motions. */
export const measurableRun = (run: Run): MeasurableRun => ({
  plane: "ZX",
  contours: run.operations.map(({ plan }) => plan.contour),
  blank: run.blank,
  path: () => run.steps.flatMap(({ from, move }, i) => (i === 0 ? [from, move.to] : [move.to])),
  printOf: printsOf(run),
});

/** What the lathe has to measure. */
export function useLatheSource({
  run,
  stockAt,
  playback,
}: {
  readonly run: Run;
  /** The stock of this very run; null while it is not known. */
  readonly stockAt: ((position: PlayPosition) => readonly Ring[]) | null;
  readonly playback: PlaybackStore;
}): MeasureSource {
  return useMemo(
    () => ({
      ...measurableRun(run),
      moment() {
        const {
            position: { step, fraction },
            playing,
          } = playback.get(),
          running = run.steps[step];
        if (playing || !stockAt) return null;
        if (!running) return { step: run.steps.length, fraction: 0 };
        const { pass } = running.move;
        return { step, fraction, block: running.block, ...(pass !== undefined && { pass }) };
      },
      stock: () => stockAt?.(playback.get().position) ?? [],
    }),
    [run, stockAt, playback],
  );
}
