import type { Cycle } from "../../cycles/define.ts";
import { exampleJob, UNSET, type Job, type SetJob } from "../../program/job.ts";
import { broughtBy } from "../work.ts";
import { outcomeBeside } from "../engine/client.ts";
import { useOutcome, type Outcome } from "../engine/outcome.ts";
import { printedText } from "../printed.ts";
import { readJob, setJobOf } from "../reading.ts";
import { handedOn, useEditor } from "../store.ts";
import { toolTable } from "../tools/work-tools.ts";
import { speaksOf } from "./open-call.ts";

/** What the guide shows a cycle with: the operator's own values, or those of the example. */
export interface GuideSource {
  readonly job: SetJob;
  readonly isOwn: boolean;
}

const typedValues = (values: Readonly<Record<string, number | "auto">>) =>
  Object.fromEntries(Object.entries(values).map(([q, value]) => [q, value === "auto" ? "FAUTO" : String(value)]));

/** The values of a call of the cycle in the open program: that of the open block, else the first; on a blank proposed for them. */
function ofProgram(cycle: Cycle): Job | null {
  if (!useEditor.getState().program || cycle.contour !== "own") return null;
  const operation = useOutcome.getState().newest?.run.operations.find(speaksOf(cycle.number));
  if (!operation?.call) return null;
  const drafts = { [cycle.number]: typedValues(operation.call.values as Readonly<Record<string, number | "auto">>) };
  return { ...exampleJob(cycle), ...UNSET, drafts, tool: operation.tool.T };
}

/** What a cycle may be shown with, the best first: as it stands in the open work, then the example of its list. */
export function guideSources(cycle: Cycle): readonly GuideSource[] {
  const { job } = useEditor.getState();
  const typed = job?.cycle === cycle.number ? job : ofProgram(cycle);
  const own = typed && readJob(typed);
  const example = { job: setJobOf(exampleJob(cycle)), isOwn: false };
  return own?.reading.values ? [{ job: own.job, isOwn: true }, example] : [example];
}

/** A job run beside the open work; null when that cannot be said. */
export const ranBeside = (job: SetJob): Promise<Outcome | null> =>
  outcomeBeside({
    name: `${job.name}.h`,
    text: printedText(job, toolTable().tools),
    encoding: "utf-8",
    ...broughtBy(handedOn(useEditor.getState())),
  });
