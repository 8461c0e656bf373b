import type { OwnCycle } from "../../program/edits/own-cycle.ts";
import { readLibrary, type OwnLibrary, type OwnList } from "../../program/edits/own-library.ts";
import { useOwn } from "./own-store.ts";

const read = new WeakMap<OwnList, OwnLibrary>();

/** The parsed list of own cycles, cached per state. */
export function libraryOf(list: OwnList): OwnLibrary {
  const known = read.get(list);
  if (known) return known;
  const made = readLibrary(list);
  read.set(list, made);
  return made;
}

/** The present description of a cycle; undefined if there is no valid one. */
export const ownCycle = (number: number): OwnCycle | undefined => libraryOf(useOwn.getState().list).cycles.get(number);

/** All valid own cycles; follows the list. */
export const useOwnCycles = (): ReadonlyMap<number, OwnCycle> => libraryOf(useOwn((s) => s.list)).cycles;
