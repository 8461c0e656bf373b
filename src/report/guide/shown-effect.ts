import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, opened } from "../../kernel/area/clip.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import type { Run, RunFinding } from "../../program/state/run-types.ts";
import { roughnessOf } from "../../sim/load/roughness.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { ownPathEnds, pathDistance } from "./path-distance.ts";

/** A program that was run and simulated. */
export interface RanProgram {
  readonly run: Run;
  readonly simulation: Simulation;
}

/** The effect of one value on a cycle, in numbers. */
export interface ShownEffect {
  readonly passes: number;
  /** The infeed as divided, mm. */
  readonly infeed: number;
  readonly seconds: number;
  /** Residual material, mm². */
  readonly residual: number;
  /** The greatest theoretical roughness from the nose radius, µm; null where unknown. */
  readonly rz: number | null;
  /** Errors and warnings, the gravest first. */
  readonly issues: readonly RunFinding["issue"][];
}

/** Differences between two values: the first less the second. */
export interface ShownChange {
  readonly passes: number;
  readonly seconds: number;
  readonly residual: number;
  /** Null where one of the two is not known. */
  readonly rz: number | null;
  /** Area in which the two parts differ, mm². */
  readonly part: number;
  /** Greatest distance between the two tool paths, mm. */
  readonly way: number;
}

/** Smaller differences between two runs are not visible: seconds, mm², µm, mm. */
export const LEAST_SEEN = { seconds: 0.05, area: 0.01, rz: 0.05, way: 0.1 } as const;

const WEIGHT = { error: 0, warning: 1, info: 2 } as const;

/** True when a program has a path and nothing that the control would refuse. */
export const makesPath = ({ run }: Pick<RanProgram, "run">): boolean =>
  run.operations.some(({ plan }) => plan.moves.length > 0) &&
  run.issues.every(({ issue }) => issue.severity !== "error");

/** The numbers of a run. */
export function shownEffect({ run, simulation }: RanProgram): ShownEffect {
  const heights = roughnessOf(simulation.final, run.steps, run.spindles).flatMap(({ by, rz }) =>
    by === "nose" && rz !== null ? [rz] : [],
  );
  return {
    passes: run.operations.reduce((sum, { plan }) => sum + plan.passes, 0),
    infeed: run.operations[0]?.plan.infeed ?? 0,
    seconds: run.seconds,
    residual: simulation.proof.residual.reduce((sum, { area }) => sum + area, 0),
    rz: heights.length > 0 ? Math.max(...heights) : null,
    issues: run.issues
      .map(({ issue }) => issue)
      .filter(({ severity }) => severity !== "info")
      .sort((a, b) => WEIGHT[a.severity] - WEIGHT[b.severity]),
  };
}

/** The areas in which two parts differ, without rounding slivers. */
export const changedAreas = (a: RanProgram, b: RanProgram): readonly Ring[] =>
  opened(
    [...difference(a.simulation.final, b.simulation.final), ...difference(b.simulation.final, a.simulation.final)],
    SLIVER,
  );

export function shownChange(a: RanProgram, b: RanProgram): ShownChange {
  const [one, other] = [shownEffect(a), shownEffect(b)];
  return {
    passes: one.passes - other.passes,
    seconds: one.seconds - other.seconds,
    residual: one.residual - other.residual,
    rz: one.rz === null || other.rz === null ? null : one.rz - other.rz,
    part: areaOf(changedAreas(a, b)),
    way: pathDistance(a.run, b.run),
  };
}

/** Least size of a picture that shows a difference of the part, mm. */
const LEAST = 8;
/** Margin of the picture, as a share of its content. */
const ROUND_IT = 0.14;

/**
 * The box shown by all pictures of a parameter: where the parts differ, else where the tool paths differ, else where
 * the tool cuts. mm, half plane.
 */
export function shownBox(all: readonly RanProgram[]): Box {
  const [first] = all;
  const differs = first ? all.flatMap((ran) => changedAreas(ran, first)) : [];
  const cuts = all.flatMap(({ run }) =>
    run.steps.flatMap(({ from, move, operation }) =>
      operation !== null && move.kind !== "rapid" ? [from, move.to] : [],
    ),
  );
  const ways =
    first && differs.length === 0
      ? all.flatMap(({ run }) => [...ownPathEnds(run, first.run), ...ownPathEnds(first.run, run)])
      : [];
  const points = ways.length > 0 ? ways : cuts;
  const rings = differs.length > 0 ? differs : points.length > 0 ? [points] : (first?.run.blank ?? []);
  const box = boxAround(rings);
  const size = Math.max(box.right - box.left, box.high - box.low, LEAST);
  const grown = (low: number, high: number): readonly [number, number] => {
    const by = Math.max(size * ROUND_IT, (LEAST - (high - low)) / 2);
    return [low - by, high + by];
  };
  const [left, right] = grown(box.left, box.right);
  const [low, high] = grown(box.low, box.high);
  return { left, right, low, high };
}
