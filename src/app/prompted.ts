import { create } from "zustand";
import type { Job } from "../program/job.ts";
import type { Entry } from "./findings/entry.ts";
import { useEditor } from "./store.ts";

/** A cycle block of the open program whose prompts are shown, dressed as a job. */
export interface PromptedBlock {
  readonly job: Job;
  /** What is wrong with this block only. */
  readonly problems: readonly Entry[];
  /** Writes a prompt into the block's text. */
  readonly setPrompt: (q: string, text: string) => void;
}

/** Whose prompts the dialog shows: those of a block while one is open, otherwise those of the job. */
export const usePrompted = create<{ readonly block: PromptedBlock | null }>(() => ({ block: null }));

/** The job whose prompts are shown; null where none are. */
export const promptedJob = (): Job | null => usePrompted.getState().block?.job ?? useEditor.getState().job;

/** The same, followed by a component. */
export function usePromptedJob(): Job | null {
  const block = usePrompted((p) => p.block);
  const job = useEditor((s) => s.job);
  return block?.job ?? job;
}
