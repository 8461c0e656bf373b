import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { withCalls } from "../../program/tools/renumber-calls.ts";
import {
  keepTools,
  renumberedTools,
  type KeepAs,
  type KeptTools,
  type ToolPair,
} from "../../program/tools/tool-difference.ts";
import { editProgram, sessionView, useSession } from "../../app/fields/blocks/session.ts";
import { shownFile } from "../../app/document/shown-file.ts";
import { completeJob } from "../../app/document/reading.ts";
import { asOneStep } from "../../app/document/steps.ts";
import { changeJob, changeProgram, bundleOf, flushEdits, setBundle, useEditor } from "../../app/document/store.ts";
import { editTools, useTools } from "../../app/document/tool-store.ts";
import { onlyBundle, textsOf, withText, type ProgramWork } from "../../app/document/work.ts";

type Renumbering = KeptTools["moved"];

/** Keeps the tools of the open work in the table of this device, as one step of undo; returns the result. */
export function keepWorkTools(choice: (beside: ToolPair) => KeepAs): KeptTools {
  const { list } = useTools.getState();
  const kept = keepTools(list, bundleOf(useEditor.getState()).tools ?? [], choice);
  editTools(() => kept.list);
  return kept;
}

/** Switches the open work to the table of this device, as one step of undo. */
export function switchToDeviceTable(): void {
  flushEdits();
  const { tools: _, ...others } = onlyBundle(bundleOf(useEditor.getState()));
  setBundle(others);
}

/** Switches the open work to the control of this device, as one step of undo. */
export function switchToDeviceControl(): void {
  flushEdits();
  const { control: _, ...others } = onlyBundle(bundleOf(useEditor.getState()));
  setBundle(others);
}

/** Switches the times of the open work to the machine of this device, as one step of undo. */
export function switchToDeviceMachine(): void {
  flushEdits();
  const { machine: _, ...others } = onlyBundle(bundleOf(useEditor.getState()));
  setBundle(others);
}

/** Number of calls in the open work that name a renumbered tool. */
export function countAffectedCalls(moved: Renumbering): number {
  flushEdits();
  const { job, program } = useEditor.getState();
  if (job) return moved.some(({ from }) => from === completeJob(job).tool) ? 1 : 0;
  return program ? textsOf(program).reduce((sum, { text }) => sum + withCalls(parse(text), moved).changed, 0) : 0;
}

/** Renumbers tools of the open work, in its calls and in the included tools, as one step of undo. */
export function renumberCalls(moved: Renumbering): void {
  flushEdits();
  const { job, program } = useEditor.getState();
  const toolsOf = (tools: NonNullable<ProgramWork["tools"]>) => ({ tools: renumberedTools(tools, moved) });
  if (job) {
    const called = moved.find(({ from }) => from === completeJob(job).tool);
    return changeJob((now) => ({ ...now, ...(called && { tool: called.to }), ...(now.tools && toolsOf(now.tools)) }));
  }
  if (!program) return;
  // The open text is changed in its editor, to keep one history.
  const inEditor = sessionView() ? fileKey(shownFile(program).name) : null;
  const texts = textsOf(program).filter(({ name }) => fileKey(name) !== inEditor);
  asOneStep(() => {
    changeProgram((now) => ({
      ...texts.reduce(
        (work, { name, text }) => withText(work, fileKey(name), print(withCalls(parse(text), moved).program)),
        now,
      ),
      ...(now.tools && toolsOf(now.tools)),
    }));
    const { program: shown, changed } = withCalls(useSession.getState().reading.program, moved);
    if (inEditor !== null && changed > 0) editProgram(shown, null);
  });
}
