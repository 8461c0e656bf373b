import { useMemo } from "react";
import type { MeasuredMoment } from "../../kernel/measured.ts";
import { partPoint, partSegment } from "../../kernel/plane.ts";
import type { Pt, Ring } from "../../kernel/point.ts";
import type { Run } from "../../program/run-types.ts";
import { standingAbove } from "../../sim/plane/body.ts";
import { areasAt, type MilledStock } from "../../sim/plane/milled.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Chain } from "../../view/measure/edges.ts";
import { printsOf, printsOfMilled } from "../../view/measure/print.ts";
import type { MeasuredWork } from "../../view/measure/reading.ts";
import type { PlaybackStore } from "../lathe/playback-store.ts";

/**
 * What a picture has to measure. The pieces of measuring know no more of a picture than this and its viewport: the two axes are z to the
 * right and r upwards, whatever they are called. A milled plane ("XY") gives X as z and Y as r (`partPoint`, `partSegment`); in it nothing
 * is mirrored and a diameter is that of a circle.
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

/** The outline of the blank, seen from above. */
const groundOf = ({ cuboid, blank }: Run): readonly Ring[] => standingAbove({ block: cuboid, turned: cuboid ? null : blank }, -Infinity);

/** The lathe's half plane of a run, or what it mills: contours of approaches, and the ends of its motions. */
export const measurableRun = (run: Run, plane: MeasureSource["plane"]): MeasurableRun =>
  plane === "ZX"
    ? {
      plane,
      contours: run.operations.map(({ plan }) => plan.contour),
      blank: run.blank,
      path: () => run.steps.flatMap(({ from, move }, i) => (i === 0 ? [from, move.to] : [move.to])),
      printOf: printsOf(run),
    }
    : {
      plane,
      contours: run.approaches.filter((each) => each.plane === "XY").map(({ contour }) => contour.map(partSegment)),
      blank: groundOf(run),
      path: () => run.plane.map(({ to }) => partPoint(to)),
      printOf: printsOfMilled([...run.blank, ...groundOf(run)], run.plane),
    };

/** What the lathe has to measure. */
export function useLatheSource({ run, stockAt, playback }: {
  readonly run: Run;
  /** The stock of this very run; null while it is not known. */
  readonly stockAt: ((position: PlayPosition) => readonly Ring[]) | null;
  readonly playback: PlaybackStore;
}): MeasureSource {
  return useMemo(() => ({
    ...measurableRun(run, "ZX"),
    moment() {
      const { position: { step, fraction }, playing } = playback.get(), running = run.steps[step];
      if (playing || !stockAt) return null;
      if (!running) return { step: run.steps.length, fraction: 0 };
      const { pass } = running.move;
      return { step, fraction, block: running.block, ...(pass !== undefined && { pass }) };
    },
    stock: () => stockAt?.(playback.get().position) ?? [],
  }), [run, stockAt, playback]);
}

/** What the working plane of milling has to measure: contours, the outline of the blank, milled edges, ends of motions. */
export function usePlaneSource(run: Run, stock: MilledStock | null, playback: PlaybackStore): MeasureSource {
  return useMemo(() => ({
    ...measurableRun(run, "XY"),
    moment() {
      const { position: { step, fraction }, playing } = playback.get(), running = run.plane[step];
      if (playing || !stock || stock.reached() < step) return null;
      return running ? { step, fraction, block: running.block } : { step: run.plane.length, fraction: 0 };
    },
    stock: () => (stock ? areasAt(stock.at(playback.get().position)).flat() : []),
  }), [run, stock, playback]);
}
