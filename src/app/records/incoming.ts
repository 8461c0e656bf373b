import { create } from "zustand";
import { toFirstPrompt } from "../place/place.ts";
import type { ReadArchive } from "./archive.ts";
import { startWork } from "./keep.ts";
import type { Work } from "../document/work.ts";

/** A received work, opened only after confirmation. */
export interface Incoming {
  readonly work: Work;
  readonly from: "link" | "file";
}

export const useIncoming = create<{ readonly incoming: Incoming | null }>(() => ({ incoming: null }));

/** The work of a shared file; null for any other file. */
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

/** Opens it as a new work; the previous one stays saved. */
export function takeIncoming({ work }: Incoming): void {
  leaveIncoming();
  toFirstPrompt();
  void startWork(work);
}
