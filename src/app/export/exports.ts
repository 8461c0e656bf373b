import type { Segment } from "../../kernel/point.ts";
import type { DxfLayer } from "../../program/write-dxf.ts";
import type { Run } from "../../program/run-types.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import { stockAt } from "../../sim/stock.ts";
import type { Ring } from "../../kernel/point.ts";
import { finishedBody, isBody } from "../../view/solid/bodies.ts";

/** Bodies that can be written, in the order in which they are offered. */
export const BODIES = ["part", "blank", "stock"] as const;
export type BodyName = (typeof BODIES)[number];

/** Why something is not there to be written. */
export type ExportLack = "noBlank" | "noTurning" | "nothingLeft" | "noCycle" | "noContour";

export type OfferedBody = { readonly rings: readonly Ring[] } | { readonly lack: ExportLack };

const offered = (rings: readonly Ring[], lack: ExportLack): OfferedBody => (isBody(rings) ? { rings } : { lack });

/** The bodies of a run at a position of its playback, or why there is none. */
export function bodiesOf(run: Run, simulation: Simulation, position: PlayPosition): Readonly<Record<BodyName, OfferedBody>> {
  if (run.blank.length === 0) {
    const lack = run.steps.length === 0 && run.plane.length > 0 ? "noTurning" : "noBlank";
    return { part: { lack }, blank: { lack }, stock: { lack } };
  }
  return {
    part: offered(finishedBody(simulation, run.operations), "noCycle"),
    blank: offered(run.blank, "noBlank"),
    stock: offered(stockAt(simulation, position), "nothingLeft"),
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
