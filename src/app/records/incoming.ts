import { create } from "zustand";
import { toFirstPrompt } from "../place/place.ts";
import type { ReadArchive } from "./archive.ts";
import { startWork } from "./keep.ts";
import type { Work } from "../document/work.ts";

/** A work that came from elsewhere and waits for a word: nothing is opened before. */
export interface Incoming {
  readonly work: Work;
  readonly from: "link" | "file";
}

export const useIncoming = create<{ readonly incoming: Incoming | null }>(() => ({ incoming: null }));

/** The one work of a file that it was handed on in; null for a file of anything else. */
export function handedWork(read: ReadArchive | object): Work | null {
  if (!("works" in read)) return null;
  const {
    works: [first, ...others],
    own,
    settings,
    unread,
  } = read;
  return first?.job.tools && others.length === 0 && !own && !settings && unread.length === 0 ? first.job : null;
}

/** Shows what a link or a file holds. */
export const showIncoming = (incoming: Incoming): void => useIncoming.setState({ incoming });

export const leaveIncoming = (): void => useIncoming.setState({ incoming: null });

/** Opens it as a work of its own; what was open stays on the device. */
export function takeIncoming({ work }: Incoming): void {
  leaveIncoming();
  toFirstPrompt();
  startWork(work);
}
