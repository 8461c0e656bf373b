import type { Cycle, TurnedShape, Use } from "./define.ts";
import { firstValues } from "./first-values.ts";
import type { Values } from "./params.ts";

/** The shapes of a group with a contour of its own. */
const OF_GROUP: Readonly<Record<Cycle["group"], readonly TurnedShape[]>> = {
  special: [],
  longitudinal: ["step"],
  transverse: ["step"],
  recessTurning: ["groove"],
  recessing: ["groove"],
  thread: ["thread"],
};

/** A flank at the start of a shoulder goes into the material: that is a plunge. */
const falls = ({ params }: Cycle) => Object.values(params).some((p) => p.text === "flankAngle");

/** The shapes for which a cycle is proposed: stated in its file, or derived from its group and its contour. */
export function useOf(cycle: Cycle): Use {
  if (cycle.use) return cycle.use;
  const { group, contour } = cycle;
  // A thread along a contour is proposed for that contour only.
  if (group === "thread" || group === "special") return { shapes: contour === "own" ? OF_GROUP[group] : [] };
  if (contour === "free") return { shapes: ["free"] };
  const turned = group === "longitudinal" || group === "transverse";
  return { shapes: turned && falls(cycle) ? ["plunge"] : OF_GROUP[group] };
}

/** The values of the printed example. */
const examples = (cycle: Cycle) => firstValues(cycle) as Values<Cycle["params"]>;

/** Whether a cycle takes its depth along the axis (a face, a groove in one) or towards it. */
export const worksAcross = (cycle: Cycle): boolean =>
  cycle.outline(examples(cycle), { contour: null, start: null }).frame.transverse;
