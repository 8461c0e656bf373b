import type { Plan } from "../../kernel/plan/plan.ts";
import type { Step } from "../../kernel/time/step.ts";
import { toDiameter } from "../../kernel/units.ts";
import type { CallResult } from "./call-result.ts";
import type { Machine } from "../state/machine.ts";
import type { Defined } from "../state/modal.ts";
import type { Operation } from "../state/run-types.ts";
import { stepOf, timed, type TimedSteps } from "../state/step-of.ts";

/** A called cycle with its plan. */
export interface Performed extends Pick<Operation, "cycle" | "start" | "tool" | "contourLines"> {
  readonly defined: Defined;
  readonly answer: CallResult;
}

/** The moves of a plan as steps of the next operation. */
function stepsOf(machine: Machine, { start, tool }: Performed, plan: Plan, index: number): readonly Step[] {
  const {
    log,
    spindle,
    clock: { rapid },
  } = machine;
  const what = {
    tool: plan.tool ?? tool,
    block: log.numberOf(index) ?? 0,
    operation: log.operations.length,
    ...log.lineOf(index),
  };
  let from = start;
  return plan.moves.map((move) => {
    const step = stepOf({ from, move, ...what }, spindle, rapid);
    from = move.to;
    return step;
  });
}

/** Reuses the step objects of the previous run where the steps are equal. */
function knownSteps(machine: Machine, performed: Performed, index: number): TimedSteps {
  const {
    log,
    shop: { memory },
  } = machine;
  const { plan } = performed.answer;
  const make = () => timed(stepsOf(machine, performed, plan, index));
  if (!memory) return make();
  const { file = "", line = 0 } = log.lineOf(index);
  const asked = `steps ${log.operations.length} ${log.numberOf(index) ?? 0} ${line} ${file}\n${memory.labelOf(performed.answer)}`;
  return memory.cached(asked, make, ({ steps }) => steps.length);
}

/** Runs the moves of a plan up to the limit of moves, and records the operation. */
export function perform(machine: Machine, performed: Performed, index: number): void {
  const { log } = machine;
  const {
    defined,
    answer: { plan, found, call },
    ...called
  } = performed;
  const firstStep = log.steps.length;
  const all = knownSteps(machine, performed, index),
    { room } = machine;
  const run = all.steps.length <= room ? all : timed(all.steps.slice(0, room));
  machine.addSteps(run, index);
  if (run !== all) machine.roomForMove(index);
  const end = plan.moves.at(-1)?.to ?? called.start;
  machine.setPlace({ at: { x: toDiameter(end.r), y: null, z: end.z }, last: null });
  const { file, ...definition } = log.placeOf(defined.index);
  log.note("operations", {
    block: log.numberOf(index) ?? 0,
    definedIn: definition.block,
    definedLine: definition.line,
    ...(file !== undefined && { definedFile: file }),
    ...called,
    plan,
    issues: found,
    call,
    feedUnit: machine.feedUnit,
    spindle: machine.now.spindle,
    seconds: run.seconds,
    firstStep,
    lastStep: log.steps.length - 1,
  });
}
