import { cycleByNumber } from "../../cycles/index.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { difference } from "../../kernel/area/clip.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { parse } from "../../nc/parse.ts";
import { operationsOf } from "../../program/edits/operations.ts";
import type { Operation, Run } from "../../program/state/run-types.ts";
import type { ComparedOperation, ThreadStretch } from "../../planning/compare-plans.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import { simulateCuts } from "../../sim/simulate.ts";
import type { Answer } from "../judge/judgement.ts";

/** An operation of a program as a working plan has them. */
export interface ProgramOperation extends ComparedOperation {
  /** Its index among the operations of the program. */
  readonly unit: number;
  /** Values by parameter, and those of the spindle as a plan names them: speed and its limit. */
  readonly values: Readonly<Record<string, number>>;
  /** mm² of the half section. */
  readonly cut: number;
}

/** For each step the operation of the program that it belongs to. Tool change and retraction belong to the cut. */
function unitsOfSteps({ steps, stepBlocks }: Run, text: string): readonly number[] {
  const { units, sections } = operationsOf(parse(text));
  const within = (block: number, range: { readonly from: number; readonly to: number }) =>
    block >= range.from && block < range.to;
  let last = 0;
  return steps.map((_, i) => {
    const block = stepBlocks[i] ?? -1;
    const section = sections.find((each) => within(block, each));
    const own = section?.units.find((unit) => within(block, units[unit] ?? section.opening));
    const edge = section && (within(block, section.opening) ? section.units[0] : section.units.at(-1));
    // A called subprogram belongs to the operation that calls it.
    return (last = own ?? edge ?? last);
  });
}

/** The stock after some steps, parts that came off included. */
function stockAfter({ run }: Answer, count: number): readonly Ring[] {
  const operations = run.operations.filter(({ lastStep }) => lastStep < count);
  return producedParts(simulateCuts({ ...run, steps: run.steps.slice(0, count), operations }, Infinity));
}

function threadOf(operations: readonly Operation[]): ThreadStretch | null {
  const thread = operations.find(({ plan }) => plan.thread !== undefined);
  if (!thread) return null;
  const { left, right } = boxOf(thread.plan.contour.flatMap(({ from, to }) => [from, to]));
  return { front: right, rear: left, isInside: thread.plan.openSide.r < 0 };
}

function valuesOf([operation]: readonly Operation[]): Readonly<Record<string, number>> {
  const called = Object.entries(operation?.call?.values ?? {}).filter(
    (entry): entry is [string, number] => typeof entry[1] === "number",
  );
  const spindle = operation?.spindle;
  const speed: Readonly<Record<string, number>> =
    spindle?.kind === "surface"
      ? { speed: spindle.cuttingSpeed, limit: spindle.limit }
      : { speed: spindle?.speed ?? NaN };
  return { ...Object.fromEntries(called), ...(spindle && speed) };
}

/**
 * The operations of a program in the order in which it runs them, with the stock that each took.
 *
 * @param change Time of a tool change, s.
 */
export function programOperations(answer: Answer, change: number): readonly ProgramOperation[] {
  const { run, text } = answer;
  const units = unitsOfSteps(run, text);
  const found: ProgramOperation[] = [];
  let before: readonly Ring[] = run.blank;
  for (let first = 0; first < units.length;) {
    const unit = units[first] ?? 0;
    let next = first;
    while (next < units.length && units[next] === unit) next += 1;
    const steps = run.steps.slice(first, next);
    const called = run.operations.filter(({ firstStep, lastStep }) => lastStep >= first && firstStep < next);
    const tool = steps.find(({ move }) => move.kind !== "rapid")?.tool.T ?? steps[0]?.tool.T ?? NaN;
    const after = stockAfter(answer, next);
    const thread = threadOf(called),
      taken = thread ? [] : difference(before, after);
    const changes = found.at(-1)?.tool === tool ? 0 : 1;
    const cycle = called[0]?.cycle ?? null;
    found.push({
      unit,
      cycle: cycle !== null && cycleByNumber(cycle) ? cycle : null,
      tool,
      seconds: steps.reduce((sum, { seconds }) => sum + seconds, 0) + changes * change,
      taken,
      thread,
      values: valuesOf(called),
      cut: areaOf(taken),
    });
    before = after;
    first = next;
  }
  return found;
}
