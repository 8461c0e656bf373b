import type { HandedOn, TaskWork } from "../../program/job/job.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import type { ToolList } from "../../program/tools/tool-list.ts";
import { useSettings } from "../base/settings/settings.ts";
import { handedOn, useEditor } from "./store.ts";
import { toolsOnDevice, useTools } from "./tool-store.ts";

/** The tools that a work runs with: those it was handed on with, or the table of this device. */
const listOf = ({ tools }: HandedOn): ToolList => tools ?? useTools.getState().list;

/** How APPR and DEP move in a work: as it was handed on, or as this device is set. */
const controlOf = ({ control }: HandedOn): Control => control ?? useSettings.getState().control;

/** A task is judged without a machine, so its work is timed without one. */
type TimedWork = HandedOn & { readonly task?: TaskWork };

/**
 * The text of the machine file that times of a work are worked out with: as it was handed on, or as this device is set.
 * Empty for none.
 */
export const machineTextOf = ({ machine, task }: TimedWork): string =>
  task ? "" : (machine ?? useSettings.getState().machine);

/**
 * What a work runs with, whether it is open or not: the tools that can be called, those that are refused, and the
 * control.
 */
export const shopOf = (work: HandedOn) => ({ table: toolsOnDevice(listOf(work)).table, control: controlOf(work) });

/** The tools that the open work runs with. */
export const listInUse = (): ToolList => listOf(handedOn(useEditor.getState()));

/** The tools of the open work as they are now: those that can be called, and those that are refused. */
export const toolTable = () => toolsOnDevice(listInUse()).table;

/** The tools that the open work can call; follows the work and the table. */
export function useToolList() {
  const shop = useTools((s) => s.list);
  const own = useEditor((s) => handedOn(s).tools);
  return toolsOnDevice(own ?? shop).table.tools;
}

/** How APPR and DEP move in the open work. */
export const controlInUse = (): Control => controlOf(handedOn(useEditor.getState()));

/** The text of the machine file of the open work; empty for none. */
export const machineInUse = (): string => machineTextOf(handedOn(useEditor.getState()));
