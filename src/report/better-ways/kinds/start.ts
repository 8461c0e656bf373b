import { boxAround } from "../../../kernel/area/box.ts";
import { IN_MM, radius, roundedDownTo, roundedUpTo, toDiameter } from "../../../kernel/units.ts";
import { withBlock } from "../../../nc/edit.ts";
import type { Program } from "../../../nc/program.ts";
import { callsCycle } from "../../../program/edits/operations.ts";
import { changeOf, type Change } from "../change.ts";
import type { ProgramSituation, TurningUnit } from "../situation.ts";
import { cutsAir, stockBefore } from "../stock-before.ts";

/** Step of a start point in the unit of the program, and the least way that is worth a change, mm. */
const STEPS = { mm: 0.1, inch: 0.005 } as const;
const LEAST_WAY = 0.1;
/** Clearance that stays above stock, mm; beside it none is needed. */
const CLEARANCE = 1;
/** Most operations whose stock is cut again to look for it. */
const MOST = 6;

/** The block that positions an axis last before the call of an operation, with its value; null without one. */
function positioningOf({ blocks }: Program, { definition }: TurningUnit, from: number, axis: "X" | "Z") {
  const call = blocks.findIndex(({ statement: s }, i) => i > definition && callsCycle(s));
  for (let index = call; index >= from; index -= 1) {
    const s = blocks[index]?.statement;
    const word = s?.kind === "path" ? s.words.axes.find((each) => each.axis === axis) : undefined;
    if (s?.kind === "path" && word)
      return typeof word.value === "number" && !word.incremental ? { index, s, value: word.value } : null;
  }
  return null;
}

/** The way by which an operation can begin nearer to the stock that it cuts, mm, along its infeed. */
function spareWay(situation: ProgramSituation, of: TurningUnit): number {
  const { plan, start } = of.operation;
  const { whole, inArea } = stockBefore(situation, of);
  if (inArea.length === 0) return 0;
  const [all, there] = [boxAround(whole), boxAround(inArea)];
  const { z, r } = plan.openSide;
  const isBeside = r !== 0 ? start.z > all.right || start.z < all.left : start.r > all.high || start.r < all.low;
  const way =
    r !== 0
      ? r > 0
        ? start.r - there.high
        : there.low - start.r
      : z > 0
        ? start.z - there.right
        : there.left - start.z;
  return isBeside ? way : way - CLEARANCE;
}

/** Passes in the air in front of the stock: the cycle begins nearer. */
export function start(situation: ProgramSituation): readonly Change[] {
  const { program, all, units, simulation, run } = situation;
  const inAir = units.filter((of) => cutsAir(situation, of));
  return inAir.slice(0, MOST).flatMap((of): readonly Change[] => {
    const { unit, index, operation } = of;
    const { openSide, passes } = operation.plan;
    const axis = openSide.r !== 0 ? "X" : "Z";
    const found = positioningOf(program, of, all.units[unit]?.from ?? 0, axis);
    const way = spareWay(situation, of);
    if (!found || way < LEAST_WAY) return [];
    // X is a diameter; the start is rounded away from the stock.
    const nearer = axis === "X" ? toDiameter(radius(way)) * openSide.r : way * openSide.z;
    const { unit: length } = run.program;
    const near = found.value - nearer / IN_MM[length];
    const to = (nearer > 0 ? roundedUpTo : roundedDownTo)(STEPS[length], near);
    if ((found.value - to) * nearer <= 0) return [];
    const words = {
      ...found.s.words,
      axes: found.s.words.axes.map((each) => (each.axis === axis ? { ...each, value: to } : each)),
    };
    const air = simulation.proof.operations[index]?.airPasses ?? 0;
    const expected = (operation.seconds * air) / Math.max(1, passes);
    return [
      changeOf({ kind: "start", units: [unit], value: { at: axis, from: found.value, to } }, expected, () =>
        withBlock(program, found.index, { ...found.s, words }),
      ),
    ];
  });
}
