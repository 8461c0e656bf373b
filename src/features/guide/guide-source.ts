import type { Cycle } from "../../cycles/define.ts";
import { beginsAtTip } from "../../cycles/shape-request.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { toDiameter } from "../../kernel/units.ts";
import { exampleJob, UNSET, type Job, type SetJob, type SpindleDraft } from "../../program/job/job.ts";
import type { Operation } from "../../program/state/run-types.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { rowsOf } from "../../program/job/requested-shape.ts";
import { onlyBundle } from "../../app/document/work.ts";
import { outcomeOfOther } from "../../app/calculation/other-outcome.ts";
import { useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { printedText } from "../../app/document/printed.ts";
import { readJob, completeJob } from "../../app/document/reading.ts";
import { bundleOf, useEditor } from "../../app/document/store.ts";
import { toolTable } from "../../app/document/work-tools.ts";
import { useShownOtherFile } from "../../app/document/shown-file.ts";
import { useOpenCall } from "../../app/place/open-call.ts";
import { isGuidedCall } from "../../app/fields/said/open-call.ts";

/** The values that the guide shows a cycle with: the operator's own, or those of the example. */
export interface GuideSource {
  readonly job: SetJob;
  readonly isOwn: boolean;
}

const typedValues = (values: Readonly<Record<string, number | "auto">>) =>
  Object.fromEntries(Object.entries(values).map(([q, value]) => [q, value === "auto" ? "FAUTO" : String(value)]));

/** The spindle as typed values; a limit missing from the program is that of the example. */
function spindleAsTyped(spindle: Spindle | null, { spindle: example }: Job): SpindleDraft {
  if (!spindle) return example;
  if (spindle.kind === "constant") return { ...example, mode: "constant", speed: String(spindle.speed) };
  const { cuttingSpeed, limit } = spindle;
  return {
    ...example,
    mode: "surface",
    cuttingSpeed: String(cuttingSpeed),
    ...(limit > 0 && { limit: String(limit) }),
  };
}

/** Jobs by the operation they were made from. */
const cachedJobs = new WeakMap<Operation, Job>();

/**
 * A job from a call of the cycle in the open program, that of the open block, else the first: its values, contour, tool
 * and spindle; with a proposed blank, and its start if the contour begins there.
 */
function jobOfProgram(cycle: Cycle): Job | null {
  if (!useEditor.getState().program) return null;
  const operation = useOutcome.getState().newest?.run.operations.find(isGuidedCall(cycle.number));
  if (!operation?.call) return null;
  const known = cachedJobs.get(operation);
  if (known) return known;
  const {
    values,
    given: { contour },
    start,
  } = operation.call;
  if (cycle.contour === "free" && !contour) return null;
  const example = exampleJob(cycle);
  const job: Job = {
    ...example,
    ...UNSET,
    drafts: { [cycle.number]: typedValues(values as Readonly<Record<string, number | "auto">>) },
    contour: rowsOf(contour ?? []),
    tool: operation.tool.T,
    spindle: spindleAsTyped(operation.spindle, example),
    perRevolution: operation.feedUnit === "mm/rev",
    ...(beginsAtTip(cycle) && { start: { x: positionAsTyped(toDiameter(start.r)), z: positionAsTyped(start.z) } }),
  };
  cachedJobs.set(operation, job);
  return job;
}

/** The possible sources of a cycle, the best first: the open work, then the example of its list. */
export function guideSources(cycle: Cycle): readonly GuideSource[] {
  const { job } = useEditor.getState();
  const typed = job?.cycle === cycle.number ? job : jobOfProgram(cycle);
  const own = typed && readJob(typed);
  const example = { job: completeJob(exampleJob(cycle)), isOwn: false };
  return own?.reading.values ? [{ job: own.job, isOwn: true }, example] : [example];
}

/** Changes whenever the shown values of a cycle change. */
export function useGuideSource(cycle: Cycle): string {
  useEditor();
  useOutcome((s) => s.newest);
  useOpenCall();
  useShownOtherFile();
  return JSON.stringify(guideSources(cycle).map(({ job: { remarks: _, measured: __, name: ___, ...job } }) => job));
}

/** Simulates a job apart from the open work; null if that fails. */
export const simulatedJob = (job: SetJob): Promise<Outcome | null> =>
  outcomeOfOther(
    {
      name: `${job.name}.h`,
      text: printedText(job, toolTable().tools),
      encoding: "utf-8",
      ...onlyBundle(bundleOf(useEditor.getState())),
    },
    job,
  );
