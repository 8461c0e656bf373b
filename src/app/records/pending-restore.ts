import { retryImport } from "../base/parts.ts";
import { create } from "zustand";
import { handedWork, showIncoming } from "./incoming.ts";
import type { ArchiveProblem, ReadArchive } from "./archive.ts";

/** A backup to restore: its content, or why it cannot be read. */
export interface PendingRestore {
  readonly name: string;
  readonly archive: ReadArchive | null;
  readonly problem: ArchiveProblem | "unreadable" | null;
}

/** Null if there is none. */
export const usePendingRestore = create<{ readonly shown: PendingRestore | null }>(() => ({ shown: null }));

export const closeRestore = (): void => usePendingRestore.setState({ shown: null });

/** Backups are the only zip files opened here. */
export const isArchiveName = (name: string): boolean => /\.zip$/i.test(name);

/** Reads a backup and shows its content; nothing is restored yet. */
export async function readBackup(file: File): Promise<void> {
  const { name } = file;
  const { ARCHIVE_LIMITS, readArchive } = await retryImport(() => import("./archive.ts"));
  try {
    if (file.size > ARCHIVE_LIMITS.packed)
      return usePendingRestore.setState({ shown: { name, archive: null, problem: "tooLarge" } });
    const read = readArchive(new Uint8Array(await file.arrayBuffer()));
    const handed = handedWork(read);
    if (handed) return showIncoming({ work: handed, from: "file" });
    const shown =
      "problem" in read ? { name, archive: null, problem: read.problem } : { name, archive: read, problem: null };
    usePendingRestore.setState({ shown });
  } catch {
    usePendingRestore.setState({ shown: { name, archive: null, problem: "unreadable" } });
  }
}
