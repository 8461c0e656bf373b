import { create } from "zustand";
import type { ProgramWork } from "./work.ts";

/** Several programs that were opened at once and do not call each other: the operator chooses which to open. */
export interface ProgramChoice {
  /** Each main program with its called files. */
  readonly works: readonly ProgramWork[];
  readonly skipped: number;
  readonly isCut: boolean;
  readonly open: (works: readonly ProgramWork[]) => void;
  readonly together: () => void;
}

export const useProgramChoice = create<{ readonly choice: ProgramChoice | null }>(() => ({ choice: null }));
export const askWhichPrograms = (choice: ProgramChoice): void => useProgramChoice.setState({ choice });
export const closeProgramChoice = (): void => useProgramChoice.setState({ choice: null });
