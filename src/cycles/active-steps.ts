import type { Cycle, Group } from "./define.ts";
import type { Param, Topic } from "./params.ts";

/** The numbered steps of the manual's two sequences in which a value acts; empty where it acts in none. */
export interface ActiveSteps {
  readonly rough: readonly number[];
  readonly finish: readonly number[];
}

type Acting = readonly [rough: readonly number[], finish: readonly number[]];
type Sequence = Exclude<Group, "special">;

/** The step that repeats the steps before it: "repeat until …". */
const REPEATS: Readonly<Record<Sequence, number>> = {
  longitudinal: 5,
  transverse: 5,
  recessTurning: 6,
  recessing: 5,
  thread: 5,
};

const NOWHERE: Acting = [[], []];

const turning: Partial<Record<Topic, Acting>> = {
  outline: [[5], [2]],
  element: [[5], [2]],
  clearance: [[1], [3]],
  infeed: [[1, 3, 5], []],
  oversizeDiameter: [[5], [2]],
  oversizeZ: [[5], [2]],
  roughingFeed: [[2], []],
  finishingFeed: [[], [2]],
  plungingFeed: [[2], []],
  reverse: [[2], [2]],
  smoothing: [[3], []],
  plunging: [[2], [2]],
  limits: [[2], [2]],
  limitDiameter: [[2], [2]],
  limitZ: [[2], [2]],
  allowance: [[1], []],
  cuttingLines: [[1, 4], []],
};

const recessTurning: Partial<Record<Topic, Acting>> = {
  outline: [
    [6, 7],
    [2, 3, 6],
  ],
  element: [[7], [2, 6]],
  clearance: [[7], [1]],
  infeed: [[1, 5], []],
  oversizeDiameter: [
    [6, 7],
    [2, 3, 6],
  ],
  oversizeZ: [
    [6, 7],
    [2, 3, 6],
  ],
  roughingFeed: [[2], []],
  finishingFeed: [[], [2, 3, 6]],
  plungingFeed: [[3], []],
  reverse: [[2], [2]],
  limits: [[2], [2]],
  limitDiameter: [[2], [2]],
  limitZ: [[2], [2]],
  direction: [[2, 4], []],
  offsetWidth: [[2, 7], []],
  depthCompensation: [[], [3]],
};

const recessing: Partial<Record<Topic, Acting>> = {
  outline: [[5], [2, 3, 6, 7]],
  element: [[5], [2, 6]],
  clearance: [[3], [4]],
  oversizeDiameter: [
    [1, 5],
    [2, 3, 6, 7],
  ],
  oversizeZ: [
    [1, 5],
    [2, 3, 6, 7],
  ],
  roughingFeed: [[4], []],
  finishingFeed: [[], [2, 3, 6, 7]],
  limits: [[4], [2]],
  limitDiameter: [[4], [2]],
  limitZ: [[4], [2]],
  depthLimit: [[1, 4], []],
  overlap: [[3, 4], []],
  solidFeed: [[1], []],
  retraction: [[2], []],
  dwell: [[2], []],
  comb: [[3, 4], []],
};

const thread: Partial<Record<Topic, Acting>> = {
  outline: [[2], []],
  clearance: [[1, 3], []],
  infeed: [[4, 5], []],
  threadPosition: [[1, 2], []],
  threadOrientation: [[1, 2], []],
  pitch: [[2], []],
  threadDepth: [[5], []],
  taperForm: [[2], []],
  runIn: [[1], []],
  infeedType: [[4, 5], []],
  startingAngle: [[2], []],
  threadStarts: [[7], []],
  airCuts: [[6], []],
};

const TABLES: Readonly<Record<Sequence, Partial<Record<Topic, Acting>>>> = {
  longitudinal: turning,
  transverse: turning,
  recessTurning,
  recessing,
  thread,
};

const upTo = (count: number) => Array.from({ length: count }, (_, i) => i + 1);

/** The steps of a cycle in which one of its values acts, by our reading of the printed sequences. */
export function activeSteps(
  { group, steps }: Pick<Cycle, "group" | "steps">,
  { shown, reserved }: Pick<Param, "shown" | "reserved">,
): ActiveSteps {
  if (group === "special" || reserved) return { rough: [], finish: [] };
  if (shown === "operation") return { rough: upTo(steps.rough), finish: upTo(steps.finish) };
  const [rough, finish] = TABLES[group][shown] ?? NOWHERE;
  return { rough, finish };
}

/** The roughing step that repeats the steps before it; null without one. */
export const repeatedIn = ({ group }: Pick<Cycle, "group">): number | null =>
  group === "special" ? null : REPEATS[group];
