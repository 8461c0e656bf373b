import { fileKey } from "../../../program/state/program-files.ts";
import { database } from "../../base/database.ts";
import type { FileHandle } from "./file-handle.ts";

/** A file of the device that a file of a work came from or was saved to, and what it held then. */
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

/** Those of this page: browsers that keep no handles still write back until the page is left. */
const held = new Map<string, KeptFile>();
const kept = database("files");

async function hashOf(bytes: BufferSource): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** Keeps the way to a file of the device with what it holds now. */
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

/** The way to the file of the device that belongs to a file of a work; null where none is known. */
export async function keptHandle(work: string, file: string): Promise<KeptFile | null> {
  const known = held.get(nameOf(work, file));
  if (known) return known;
  try {
    return (await kept.get<KeptFile>(nameOf(work, file))) ?? null;
  } catch {
    return null;
  }
}

/** True where the file holds other bytes than those that were read or written last. */
export async function hasChanged({ modified, size, hash }: KeptFile, now: File): Promise<boolean> {
  if (now.lastModified === modified && now.size === size) return false;
  return now.size !== size || (await hashOf(await now.arrayBuffer())) !== hash;
}

/** Forgets the files of works that are no longer kept. */
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
