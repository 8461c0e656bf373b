import { MILL, type CellName } from "../../program/tools/tool-columns.ts";
import { cellOf, isMillEntry, readEntry, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { freeNumber, newId, shippedList } from "../../program/tools/tool-list.ts";
import { closeStep } from "../../app/document/steps.ts";
import { addToolRow, NEW_TOOL } from "../../app/document/tool-row.ts";
import type { ToolKind } from "../../app/place/place.ts";
import { editTools, useTools } from "../../app/document/tool-store.ts";

/** The typed text of one cell. */
export function setCell(id: string, cell: CellName, text: string): void {
  editTools(
    (list) =>
      list.map((entry) =>
        entry.id === id && cellOf(entry, cell) !== text ? { ...entry, cells: { ...entry.cells, [cell]: text } } : entry,
      ),
    `tool ${id} ${cell}`,
  );
}

/** Several cells of one row: one step of undo. */
export function setCells(id: string, cells: ToolEntry["cells"]): void {
  closeStep();
  editTools((list) =>
    list.map((entry) => (entry.id === id ? { ...entry, cells: { ...entry.cells, ...cells } } : entry)),
  );
}

/** Adds a row with the next free number and the default values; returns its id. */
export function addTool(kind: ToolKind): string {
  const T = String(freeNumber(useTools.getState().list));
  return addToolRow({ T, ...(kind === "milling" ? { TYPE: MILL } : NEW_TOOL) });
}

/** Duplicates a tool, below it, with the next free number; returns the id of the copy. */
export function duplicateTool(id: string): string {
  const { list } = useTools.getState();
  const at = list.findIndex((entry) => entry.id === id);
  const entry = list[at];
  if (!entry) return id;
  const copy = newId(list);
  const T = String(freeNumber(list, readEntry(entry).number ?? 0));
  editTools(() => [...list.slice(0, at + 1), { id: copy, cells: { ...entry.cells, T } }, ...list.slice(at + 1)]);
  return copy;
}

/** Removes a row; returns the id of the row of its kind that takes its place, null if none is left. */
export function removeTool(id: string): string | null {
  const { list } = useTools.getState();
  const entry = list.find((each) => each.id === id);
  const kin = list.filter((each) => entry && isMillEntry(each) === isMillEntry(entry));
  const at = kin.findIndex((each) => each.id === id);
  const next = kin[at + 1] ?? kin[at - 1] ?? null;
  editTools((rows) => rows.filter((entry) => entry.id !== id));
  return next?.id ?? null;
}

/** Restores the default table: one step of undo. */
export const restoreShippedTools = (): void => editTools(() => shippedList);
