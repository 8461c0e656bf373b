import { create } from "zustand";
import type { OwnList } from "../../program/edits/own-library.ts";
import { forget, goesOn, noteChange } from "./steps.ts";

/** The cycles of this device's operator, as typed. They belong to no program: any of them may call one. */
export interface Own {
  readonly list: OwnList;
}

export const useOwn = create<Own>(() => ({ list: [] }));

/** Puts a list in place; what its steps are steps of. */
export const putOwn = (list: OwnList): void => useOwn.setState({ list });

/** Changes the list as one step of undo; changes that name the same place, one after the other, are one step together. */
export function editOwn(change: (list: OwnList) => OwnList, place: string | null = null): void {
  const { list } = useOwn.getState();
  const next = change(list);
  if (next === list) return;
  putOwn(next);
  noteChange(putOwn, list, next, goesOn(place));
}

/** Puts a list in place that comes from the device or from another tab: nothing before it can be undone here. */
export function takeOwn(list: OwnList): void {
  putOwn(list);
  forget(putOwn);
}
