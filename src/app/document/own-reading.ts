import type { OwnCycle } from "../../program/edits/own-cycle.ts";
import { readLibrary, type OwnLibrary, type OwnList } from "../../program/edits/own-library.ts";
import { useOwn } from "./own-store.ts";

const read = new WeakMap<OwnList, OwnLibrary>();

/** The list read, once per state of it. */
export function libraryOf(list: OwnList): OwnLibrary {
  const known = read.get(list);
  if (known) return known;
  const made = readLibrary(list);
  read.set(list, made);
  return made;
}

/** The description of a cycle as it is now; undefined where there is none that can be used. */
export const ownCycle = (number: number): OwnCycle | undefined => libraryOf(useOwn.getState().list).cycles.get(number);

/** All that can be used; follows the list. */
export const useOwnCycles = (): ReadonlyMap<number, OwnCycle> => libraryOf(useOwn((s) => s.list)).cycles;
