import { create } from "zustand";

/** The history of the open program, which its text editor keeps: dialogs and typing are steps of the same one. */
export interface ProgramHistory {
  readonly past: boolean;
  readonly future: boolean;
  readonly undo: () => void;
  readonly redo: () => void;
}

const nothing = () => undefined;
export const noHistory: ProgramHistory = { past: false, future: false, undo: nothing, redo: nothing };
export const useProgramHistory = create<ProgramHistory>(() => noHistory);
