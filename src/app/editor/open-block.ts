import { create } from "zustand";
import type { Entry } from "../findings/entry.ts";
import type { JobReading } from "../reading.ts";

/** The open block of the program: its prompts where it is a cycle of the catalogue, and what is wrong with it. */
export interface OpenBlock {
  readonly read: JobReading | null;
  readonly problems: readonly Entry[];
}

export const useOpenBlock = create<OpenBlock>(() => ({ read: null, problems: [] }));
