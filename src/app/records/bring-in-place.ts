import { untilHere } from "../base/parts.ts";
import { create } from "zustand";
import { handedWork, showIncoming } from "./incoming.ts";
import type { ArchiveProblem, ReadArchive } from "./archive.ts";

/** A file of works that somebody wants to bring in: what is in it, or why nothing is. */
export interface Bringing {
  readonly name: string;
  readonly archive: ReadArchive | null;
  readonly problem: ArchiveProblem | "unreadable" | null;
}

/** Null while there is none. */
export const useBringing = create<{ readonly shown: Bringing | null }>(() => ({ shown: null }));

export const endBringing = (): void => useBringing.setState({ shown: null });

/** Files of works are zips; nothing else that is opened here is one. */
export const isArchiveName = (name: string): boolean => /\.zip$/i.test(name);

/** Reads a file of works and shows what is in it. Nothing is taken yet. */
export async function bringIn(file: File): Promise<void> {
  const { name } = file;
  const { ARCHIVE_LIMITS, readArchive } = await untilHere(() => import("./archive.ts"));
  try {
    if (file.size > ARCHIVE_LIMITS.packed)
      return useBringing.setState({ shown: { name, archive: null, problem: "tooLarge" } });
    const read = readArchive(new Uint8Array(await file.arrayBuffer()));
    const handed = handedWork(read);
    if (handed) return showIncoming({ work: handed, from: "file" });
    const shown =
      "problem" in read ? { name, archive: null, problem: read.problem } : { name, archive: read, problem: null };
    useBringing.setState({ shown });
  } catch {
    useBringing.setState({ shown: { name, archive: null, problem: "unreadable" } });
  }
}
