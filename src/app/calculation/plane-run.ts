import type { ApproachRun } from "../../program/tools/plane-types.ts";
import type { Run } from "../../program/state/run-types.ts";
import { planeScene, type PlaneScene } from "../../view/approach/plane-scene.ts";

/** A run as the working plane shows it. */
interface PlaneOfRun {
  readonly approaches: readonly ApproachRun[];
  readonly scene: PlaneScene;
}

const known = new WeakMap<Run, PlaneOfRun>();

/** Approaches and lines of a run in the working plane, cached per run. */
export function planeOfRun(run: Run): PlaneOfRun {
  const have = known.get(run);
  if (have) return have;
  const approaches = run.approaches.filter((a) => a.plane === "XY");
  const made = {
    approaches,
    scene: planeScene(
      run.plane,
      approaches.map((a) => a.contour),
      new Set(approaches.map((a) => a.index)),
    ),
  };
  known.set(run, made);
  return made;
}
