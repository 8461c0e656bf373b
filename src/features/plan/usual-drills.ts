import { standardDrills } from "../../program/tools/standard-drills.ts";
import type { ToolEntry } from "../../program/tools/tool-entry.ts";
import { readList, type ToolList } from "../../program/tools/tool-list.ts";
import { addTool } from "../../app/document/add-tool.ts";
import { listInUse } from "../../app/document/work-tools.ts";

/** Usual drills, taps and centre drills that a table lacks, by name, with free numbers. */
const missingDrills = (list: ToolList): readonly ToolEntry[] => {
  const has = new Set(list.map(({ cells }) => cells.NAME));
  return standardDrills(list)
    .filter(({ NAME }) => !has.has(NAME))
    .map((cells) => ({ id: `standard ${cells.T}`, cells }));
};

/** Milling tools of a table with the usual drills that it lacks. */
export const withUsualDrills = (list: ToolList) => readList([...list, ...missingDrills(list)]).table.mills;

/** Adds the usual drills that a program calls to the table of the open work. */
export function addCalledDrills(called: readonly number[]): void {
  for (const entry of missingDrills(listInUse())) if (called.includes(Number(entry.cells.T))) addTool(entry);
}
