import { temporal } from "zundo";
import { create } from "zustand";
import { readList, sameList, shippedList, type ToolList, type ToolListReading } from "../../program/tool-list.ts";

/** The tool table of this device, as typed. It belongs to no program: all of them call its tools. */
export interface Tools {
  readonly list: ToolList;
}

/** Steps that undo keeps; unchanged rows are shared. */
const HISTORY = 200;

export const useTools = create<Tools>()(
  temporal((): Tools => ({ list: shippedList }), { limit: HISTORY, equality: (past, now) => past.list === now.list }),
);

const read = new WeakMap<ToolList, ToolListReading>();

/** A table read, once per state of the table. */
export function toolsOnDevice(list: ToolList): ToolListReading {
  const known = read.get(list);
  if (known) return known;
  const made = readList(list);
  read.set(list, made);
  return made;
}

/** The tools of the table as it is now: those that can be called, and those that are refused. */
export const toolTable = () => toolsOnDevice(useTools.getState().list).table;

/** The tools that programs can call; follows the table. */
export const useToolList = () => toolsOnDevice(useTools((s) => s.list)).table.tools;

/** What was changed last; typing on in the same cell belongs to the same step of undo. */
let lastPlace: string | null = null;

/** The next change begins its own step of undo. */
export const closeToolStep = (): void => {
  lastPlace = null;
};

/** Changes the table as one step of undo; changes that name the same place, one after the other, are one step together. */
export function editTools(change: (list: ToolList) => ToolList, place: string | null = null): void {
  const { list } = useTools.getState();
  const next = change(list);
  if (next === list || sameList(next, list)) return;
  const history = useTools.temporal.getState();
  const goesOn = place !== null && place === lastPlace;
  if (goesOn) history.pause();
  useTools.setState({ list: next });
  if (goesOn) history.resume();
  lastPlace = place;
}

/** Puts a table in place that comes from the device or from another tab: nothing before it can be undone here. */
export function takeTools(list: ToolList): void {
  closeToolStep();
  useTools.setState({ list });
  useTools.temporal.getState().clear();
}

export function undoTools(): void {
  closeToolStep();
  useTools.temporal.getState().undo();
}

export function redoTools(): void {
  closeToolStep();
  useTools.temporal.getState().redo();
}
