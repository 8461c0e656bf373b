import type { ComponentType } from "react";
import { create } from "zustand";
import { slot } from "../base/slot.ts";
import type { WhichRegion } from "./asking.ts";

/** Whether it is asked which cycle makes a shape, over what is open. Undo does not touch it. */
export interface WhichPlace {
  readonly shown: boolean;
  /** The place of an opened work that is asked about; null asks about nothing in particular. */
  readonly region: WhichRegion | null;
}

export const useWhichPlace = create<WhichPlace>(() => ({ shown: false, region: null }));

export const showWhich = (region: WhichRegion | null = null): void => useWhichPlace.setState({ shown: true, region });
export const hideWhich = (): void => useWhichPlace.setState({ shown: false, region: null });

/** The question itself, over the picture or a program. */
export const whichSlot = slot<ComponentType<{ readonly done: () => void; readonly region: WhichRegion | null }>>("which cycle");
