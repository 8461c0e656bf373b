import { cycleByNumber } from "../../cycles/index.ts";
import { unpacked } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import type { Operation } from "../../program/state/run-types.ts";
import { heldWorkpiece } from "../advice/held-workpiece.ts";
import { leadOf, specificForce } from "../advice/formulas.ts";
import { bentBodies, DEFLECTION, depthForForce } from "../advice/stability.ts";
import { calledNumber, WORKS, type Attempt } from "./situation.ts";

/** The stock before a step, from the nearest mark in front of it: a little more than there is. */
function stockAt({ simulation: { checkpoints, blank } }: Attempt, step: number): readonly Ring[] {
  const mark = checkpoints.findLast((each) => each.stock !== null && each.step <= step);
  return mark?.stock ? unpacked(mark.stock) : blank;
}

/** Infeed at which the workpiece bends as far as roughing may, mm; Infinity where it is not known or does not bend. */
export function depthByWorkpiece(attempt: Attempt, material: CutMaterial, operation: Operation): number {
  const { clamping } = attempt.run;
  const { call, tool, feedUnit } = operation;
  const cycle = cycleByNumber(operation.cycle);
  // A face presses along the axis, and a plunge has no infeed.
  if (!clamping || !call || !cycle || (cycle.group !== "longitudinal" && cycle.group !== "recessTurning"))
    return Infinity;
  const feed = calledNumber({ cycle, call }, "roughingFeed");
  if (WORKS[calledNumber({ cycle, call }, "operation") ?? 0] === "finish" || feedUnit !== "mm/rev" || !feed)
    return Infinity;
  const workpiece = heldWorkpiece(stockAt(attempt, operation.firstStep), clamping);
  const kc = specificForce(material, feed * Math.sin(leadOf(tool)));
  const depths = bentBodies({ workpiece, bar: null }, material.group, DEFLECTION.rough).map(({ force }) =>
    depthForForce(force, kc, feed),
  );
  return Math.min(Infinity, ...depths);
}

/** Greatest deflection of the workpiece under a roughing pass of a program, mm; 0 where it is not known. */
export function bendingOf(attempt: Attempt, material: CutMaterial): number {
  return attempt.run.operations.reduce(
    (most, operation) =>
      Math.max(most, (DEFLECTION.rough * operation.plan.infeed) / depthByWorkpiece(attempt, material, operation)),
    0,
  );
}

/** Whether a workpiece bends further than it may. */
export const isBent = (bending: number): boolean => bending > DEFLECTION.rough;
