import { encode } from "../../document/encoding.ts";
import type { WorkFile } from "../../document/work.ts";
import { askWhere, type FileHandle } from "./file-handle.ts";
import { hasChanged, keepHandle, keptHandle } from "./kept-handles.ts";

/** Result of saving a file of a work. "changed": the device file was changed meanwhile; `bytes` is its content. */
export type SaveBack =
  | { readonly kind: "written" }
  | { readonly kind: "closed" }
  | { readonly kind: "failed" | "refused" | "gone" }
  | {
      readonly kind: "changed";
      readonly bytes: Uint8Array<ArrayBuffer>;
    };

/** Whether to overwrite a changed device file, or to ask for another one. */
export type SaveHow = "careful" | "overwrite" | "elsewhere";

/** Asks for write permission where it is missing. */
async function mayWrite(handle: FileHandle): Promise<boolean> {
  const readwrite = { mode: "readwrite" } as const;
  const given = (await handle.queryPermission?.(readwrite)) ?? "granted";
  return given === "granted" || (await handle.requestPermission?.(readwrite)) === "granted";
}

const isGone = (error: unknown): boolean => error instanceof Error && error.name === "NotFoundError";

async function write(
  work: string,
  name: string,
  handle: FileHandle,
  bytes: Uint8Array<ArrayBuffer>,
): Promise<SaveBack> {
  const out = await handle.createWritable();
  await out.write(bytes);
  await out.close();
  await keepHandle(work, name, handle, bytes);
  return { kind: "written" };
}

/**
 * Saves a file of a work to the device file it came from, or asks where. Changes made there meanwhile are never
 * overwritten without asking.
 */
export async function saveBack(work: string, { name, text, encoding }: WorkFile, how: SaveHow): Promise<SaveBack> {
  const bytes = encode(text, encoding);
  const known = how === "elsewhere" ? null : await keptHandle(work, name);
  try {
    if (!known) {
      const handle = await askWhere(name);
      return handle ? await write(work, name, handle, bytes) : { kind: "closed" };
    }
    if (!(await mayWrite(known.handle))) return { kind: "refused" };
    const now = await known.handle.getFile();
    if (how === "careful" && (await hasChanged(known, now)))
      return { kind: "changed", bytes: new Uint8Array(await now.arrayBuffer()) };
    return await write(work, name, known.handle, bytes);
  } catch (error) {
    return { kind: isGone(error) ? "gone" : "failed" };
  }
}

/** Bytes of the device file for a file of a work; null if there is none, or it may not be read. */
export async function bytesOnDevice(work: string, name: string): Promise<Uint8Array<ArrayBuffer> | null> {
  try {
    const known = await keptHandle(work, name);
    if (!known || !(await mayWrite(known.handle))) return null;
    return new Uint8Array(await (await known.handle.getFile()).arrayBuffer());
  } catch {
    return null;
  }
}
