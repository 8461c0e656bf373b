import type { HandedOn, TaskWork } from "../../program/job/job.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import type { ToolList } from "../../program/tools/tool-list.ts";
import { useSettings } from "../base/settings/settings.ts";
import { bundleOf, useEditor } from "./store.ts";
import { toolsOnDevice, useTools } from "./tool-store.ts";

/** The tools of a work: its own, or the table of this device. */
const listOf = ({ tools }: HandedOn): ToolList => tools ?? useTools.getState().list;

/** How APPR and DEP move in a work: by its own control, or by the setting of this device. */
const controlOf = ({ control }: HandedOn): Control => control ?? useSettings.getState().control;

/** An exercise is graded without a machine, so its times are calculated without one. */
type TimedWork = HandedOn & { readonly task?: TaskWork };

/** The machine file for the times of a work, as text: its own, or that of this device. Empty for none. */
export const machineTextOf = ({ machine, task }: TimedWork): string =>
  task ? "" : (machine ?? useSettings.getState().machine);

/** Tools and control of any work: the valid tools, the rejected ones, and the control. */
export const shopOf = (work: HandedOn) => ({ table: toolsOnDevice(listOf(work)).table, control: controlOf(work) });

/** The tool list of the open work. */
export const listInUse = (): ToolList => listOf(bundleOf(useEditor.getState()));

/** The parsed tools of the open work: valid and rejected ones. */
export const toolTable = () => toolsOnDevice(listInUse()).table;

/** The valid tools of the open work; follows the work and the table. */
export function useToolList() {
  const shop = useTools((s) => s.list);
  const own = useEditor((s) => bundleOf(s).tools);
  return toolsOnDevice(own ?? shop).table.tools;
}

/** How APPR and DEP move in the open work. */
export const controlInUse = (): Control => controlOf(bundleOf(useEditor.getState()));

/** The text of the machine file of the open work; empty for none. */
export const machineInUse = (): string => machineTextOf(bundleOf(useEditor.getState()));
