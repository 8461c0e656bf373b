import type { Control } from "../../program/plane-types.ts";
import type { ToolList } from "../../program/tool-list.ts";
import { useSettings } from "../settings/settings.ts";
import { handedOn, useEditor } from "../store.ts";
import { toolsOnDevice, useTools } from "./tool-store.ts";

/** The tools that the open work runs with: those it was handed on with, or the table of this device. */
export const listInUse = (): ToolList => handedOn(useEditor.getState()).tools ?? useTools.getState().list;

/** The tools of the open work as they are now: those that can be called, and those that are refused. */
export const toolTable = () => toolsOnDevice(listInUse()).table;

/** The tools that the open work can call; follows the work and the table. */
export function useToolList() {
  const shop = useTools((s) => s.list);
  const own = useEditor((s) => handedOn(s).tools);
  return toolsOnDevice(own ?? shop).table.tools;
}

/** How APPR and DEP move in the open work: as it was handed on, or as this device is set. */
export const controlInUse = (): Control => handedOn(useEditor.getState()).control ?? useSettings.getState().control;
