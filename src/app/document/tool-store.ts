import { create } from "zustand";
import { readList, sameList, shippedList, type ToolList, type ToolListReading } from "../../program/tools/tool-list.ts";
import { forget, goesOn, noteChange } from "./steps.ts";

/** The tool table of this device, as typed. It belongs to no program: all of them call its tools but those that bring their own. */
export interface Tools {
  readonly list: ToolList;
}

export const useTools = create<Tools>(() => ({ list: shippedList }));

const read = new WeakMap<ToolList, ToolListReading>();

/** A table read, once per state of the table. */
export function toolsOnDevice(list: ToolList): ToolListReading {
  const known = read.get(list);
  if (known) return known;
  const made = readList(list);
  read.set(list, made);
  return made;
}

/** Puts a table in place; what its steps are steps of. */
export const putTools = (list: ToolList): void => useTools.setState({ list });

/** Changes the table as one step of undo; changes that name the same place, one after the other, are one step together. */
export function editTools(change: (list: ToolList) => ToolList, place: string | null = null): void {
  const { list } = useTools.getState();
  const next = change(list);
  if (next === list || sameList(next, list)) return;
  putTools(next);
  noteChange(putTools, list, next, goesOn(place));
}

/** Puts a table in place that comes from the device or from another tab: nothing before it can be undone here. */
export function takeTools(list: ToolList): void {
  putTools(list);
  forget(putTools);
}
