import { create } from "zustand";

/** The cycle block whose prompts were open last: its work, its cycle, its first line (from 1). */
export interface OpenCall {
  readonly work: string | null;
  readonly cycle: number;
  readonly line: number;
}

export const useOpenCall = create<{ readonly call: OpenCall | null }>(() => ({ call: null }));

/** The last open block other than a cycle, and its word when the guide was opened. */
export interface GuidedBlock {
  readonly work: string | null;
  /** Its line in the text, from 1. */
  readonly line: number;
  readonly word: string | null;
}

export const useGuidedBlock = create<{ readonly block: GuidedBlock | null }>(() => ({ block: null }));

/** The word that was open in a block when its guide was opened. */
export function openWordOf(work: string | null, line: number): string | null {
  const { block } = useGuidedBlock.getState();
  return block?.work === work && block.line === line ? block.word : null;
}
