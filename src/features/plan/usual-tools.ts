import { usualTools } from "../../program/iso-codes/usual-tools.ts";
import { addTool } from "../../app/document/add-tool.ts";
import { listInUse } from "../../app/document/work-tools.ts";

/** Adds the usual tools that a program calls to the table of the open work. */
export function addCalledTools(called: readonly number[]): void {
  for (const entry of usualTools(listInUse())) if (called.includes(Number(entry.cells.T))) addTool(entry);
}
