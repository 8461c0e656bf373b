import { fileKey } from "../../../program/state/program-files.ts";
import { database } from "../../base/database.ts";
import type { FileHandle } from "./file-handle.ts";

/** Device file that a file of a work came from or was saved to, with its state at that time. */
export interface KeptFile {
  readonly handle: FileHandle;
  /** Milliseconds since 1970, as the file said. */
  readonly modified: number;
  readonly size: number;
  /** SHA-256 of its bytes. */
  readonly hash: string;
}

const GAP = " ";
const nameOf = (work: string, file: string): string => `${work}${GAP}${fileKey(file)}`;

/** Handles of this page. Browsers that store no handles still save back until the page is closed. */
const held = new Map<string, KeptFile>();
const kept = database("files");

async function hashOf(bytes: BufferSource): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** Stores the handle of a device file with its present state. */
export async function keepHandle(work: string, file: string, handle: FileHandle, bytes: BufferSource): Promise<void> {
  try {
    const { lastModified, size } = await handle.getFile();
    const found: KeptFile = { handle, modified: lastModified, size, hash: await hashOf(bytes) };
    held.set(nameOf(work, file), found);
    await kept.set(nameOf(work, file), found);
  } catch {
    return;
  }
}

/** Stored handle of the device file for a file of a work; null if unknown. */
export async function keptHandle(work: string, file: string): Promise<KeptFile | null> {
  const known = held.get(nameOf(work, file));
  if (known) return known;
  try {
    return (await kept.get<KeptFile>(nameOf(work, file))) ?? null;
  } catch {
    return null;
  }
}

/** True if the file has changed since it was last read or written. */
export async function hasChanged({ modified, size, hash }: KeptFile, now: File): Promise<boolean> {
  if (now.lastModified === modified && now.size === size) return false;
  return now.size !== size || (await hashOf(await now.arrayBuffer())) !== hash;
}

/** Deletes the handles of works that no longer exist. */
export async function forgetHandles(works: ReadonlySet<string>): Promise<void> {
  try {
    for (const key of await kept.keys()) {
      const [work = ""] = key.split(GAP);
      if (!works.has(work)) await kept.del(key);
    }
  } catch {
    return;
  }
}
