import type { Cuboid } from "../../kernel/area/box.ts";
import { partSegment } from "../../kernel/plane/plane.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import type { DxfLayer } from "../../program/drawing/write-dxf.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { PlayPosition, Simulation } from "../../sim/simulation.ts";
import { playerOf } from "../../sim/stock.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { finishedBody, isBody, leftBody, statedSteps, withoutThreads } from "../../view/solid/bodies.ts";
import type { WrittenBody } from "../../view/solid/export.ts";
import { runThreads, type ThreadedStock } from "../../view/solid/thread-cuts.ts";

/** Bodies to export, in the order offered. */
export const BODIES = ["part", "blank", "stock"] as const;
export type BodyName = (typeof BODIES)[number];

/** Why something cannot be exported. */
export type ExportLack = "noBlank" | "noTurning" | "nothingLeft" | "noCycle" | "noContour";

/** A body to export; `isLeft`: no cycle defines it, so it is the stock that the moves leave. */
export type OfferedBody =
  | (WrittenBody & { readonly isLeft?: true })
  | { readonly block: Cuboid }
  | { readonly lack: ExportLack };

const offered = (rings: readonly Ring[], lack: ExportLack, threads: ThreadedStock | null = null): OfferedBody =>
  isBody(rings) ? { rings, threads } : { lack };

/** The current moment of the lathe; for a milling moment, the stock turned before it. */
export function turnedMoment(
  { plane, steps }: Pick<Run, "plane" | "steps">,
  position: PlayPosition,
  showsPlane: boolean,
): PlayPosition {
  return showsPlane
    ? { step: plane[Math.min(position.step, plane.length - 1)]?.turned ?? steps.length, fraction: 0 }
    : position;
}

function partFromStock(rings: readonly Ring[], threads: (rings: readonly Ring[]) => ThreadedStock | null): OfferedBody {
  return isBody(rings) ? { rings, threads: threads(rings), isLeft: true } : { lack: "noCycle" };
}

/** The bodies of a run at a playback position, or why there is none. */
export function bodiesOf(
  run: Run,
  simulation: Simulation,
  position: PlayPosition,
): Readonly<Record<BodyName, OfferedBody>> {
  if (run.steps.length === 0 && run.plane.length > 0) {
    const none = { lack: "noTurning" } as const;
    return { part: none, blank: run.cuboid ? { block: run.cuboid } : offered(run.blank, "noBlank"), stock: none };
  }
  if (run.blank.length === 0) {
    const none = { lack: "noBlank" } as const;
    return { part: none, blank: none, stock: none };
  }
  const player = playerOf(simulation),
    threads = runThreads(run.steps, player.at, {
      stated: statedSteps(simulation),
      spindles: run.spindles,
    });
  const part = finishedBody(simulation, run.operations),
    stock = player.at(position);
  const end = { step: run.steps.length, fraction: 0 };
  return {
    part: isBody(part)
      ? { rings: part, threads: threads?.of(part, end, withoutThreads(simulation, run.operations)) ?? null }
      : partFromStock(leftBody(simulation), (left) => threads?.of(left, end) ?? null),
    blank: offered(run.blank, "noBlank"),
    stock: offered(stock, "nothingLeft", threads?.of(stock, position)),
  };
}

/** A contour to export. */
export interface OfferedContour {
  /** The block that cuts it first, and its cycle; null for the contour of an approach or departure. */
  readonly block: number;
  readonly cycle: number | null;
  /** The half section with X as a radius, or X and Y of the working plane. */
  readonly plane: "ZX" | "XY";
  readonly segments: readonly Segment[];
}

/**
 * The distinct contours of a run: roughing and finishing calls often share one, and so do an approach and its
 * departure.
 */
export function contoursOf(run: Run): readonly OfferedContour[] {
  const known = new Set<string>();
  const turned = run.operations.map(({ plan: { contour }, block, cycle }): OfferedContour => ({
    block,
    cycle,
    plane: "ZX",
    segments: contour,
  }));
  const milled = run.approaches
    .filter(({ plane }) => plane === "XY")
    .map(({ contour, block }): OfferedContour => ({
      block,
      cycle: null,
      plane: "XY",
      segments: contour.map(partSegment),
    }));
  return [...turned, ...milled].filter(({ plane, segments }) => {
    const key = plane + JSON.stringify(segments);
    const isNew = segments.length > 0 && !known.has(key);
    known.add(key);
    return isNew;
  });
}

/** Whether one drawing can contain them all: half sections and the working plane have no common axes. */
export const drawnTogether = (contours: readonly OfferedContour[]): boolean =>
  contours.every(({ plane }) => plane === contours[0]?.plane);

/** Contours as layers of a drawing: one is CONTOUR, several are CONTOUR_1 and so on. */
export const layersOf = (contours: readonly OfferedContour[]): readonly DxfLayer[] =>
  contours.map(({ segments }, i) => ({ name: contours.length === 1 ? "CONTOUR" : `CONTOUR_${i + 1}`, segments }));
