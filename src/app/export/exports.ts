import type { Segment } from "../../kernel/point.ts";
import type { DxfLayer } from "../../program/write-dxf.ts";
import type { Run } from "../../program/run-types.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import { playerOf } from "../../sim/stock.ts";
import type { Ring } from "../../kernel/point.ts";
import { finishedBody, isBody, statedSteps, withoutThreads } from "../../view/solid/bodies.ts";
import type { WrittenBody } from "../../view/solid/export.ts";
import { runThreads, type ThreadedStock } from "../../view/solid/thread-cuts.ts";

/** Bodies that can be written, in the order in which they are offered. */
export const BODIES = ["part", "blank", "stock"] as const;
export type BodyName = (typeof BODIES)[number];

/** Why something is not there to be written. */
export type ExportLack = "noBlank" | "noTurning" | "nothingLeft" | "noCycle" | "noContour";

export type OfferedBody = WrittenBody | { readonly lack: ExportLack };

const offered = (rings: readonly Ring[], lack: ExportLack, threads: ThreadedStock | null = null): OfferedBody =>
  isBody(rings) ? { rings, threads } : { lack };

/** The bodies of a run at a position of its playback, or why there is none. */
export function bodiesOf(run: Run, simulation: Simulation, position: PlayPosition): Readonly<Record<BodyName, OfferedBody>> {
  if (run.blank.length === 0) {
    const lack = run.steps.length === 0 && run.plane.length > 0 ? "noTurning" : "noBlank";
    return { part: { lack }, blank: { lack }, stock: { lack } };
  }
  const player = playerOf(simulation), threads = runThreads(run.steps, player.at, statedSteps(simulation));
  const part = finishedBody(simulation, run.operations), stock = player.at(position);
  const end = { step: run.steps.length, fraction: 0 };
  return {
    part: offered(part, "noCycle", threads?.of(part, end, withoutThreads(simulation, run.operations))),
    blank: offered(run.blank, "noBlank"),
    stock: offered(stock, "nothingLeft", threads?.of(stock, position)),
  };
}

/** A contour that can be written. */
export interface OfferedContour {
  /** Index of the operation that has it first, and its block and cycle. */
  readonly operation: number;
  readonly block: number;
  readonly cycle: number;
  readonly segments: readonly Segment[];
}

/** The contours of a run, each once: roughing and finishing calls often share one. */
export function contoursOf(run: Run): readonly OfferedContour[] {
  const known = new Set<string>();
  return run.operations.flatMap(({ plan: { contour }, block, cycle }, operation) => {
    const key = JSON.stringify(contour);
    if (contour.length === 0 || known.has(key)) return [];
    known.add(key);
    return [{ operation, block, cycle, segments: contour }];
  });
}

/** Contours as layers of a drawing: one is CONTOUR, several are CONTOUR_1 and so on. */
export const layersOf = (contours: readonly OfferedContour[]): readonly DxfLayer[] =>
  contours.map(({ segments }, i) => ({ name: contours.length === 1 ? "CONTOUR" : `CONTOUR_${i + 1}`, segments }));
