import { storedText } from "./storage.ts";

/** Stored once the browser was asked for permanent storage, so that it is not asked again by itself. */
const ASKED = storedText("persist");

const storage = (): StorageManager | undefined => (typeof navigator === "undefined" ? undefined : navigator.storage);

/** Asks the browser for permanent storage; false if it does not grant it. */
export async function askToPersist(): Promise<boolean> {
  try {
    return (await storage()?.persist()) ?? false;
  } catch {
    return false;
  }
}

/** Asks once, after the first work was saved: then there is something to lose. */
export function persistOnce(): void {
  if (ASKED.get() === null && ASKED.set("asked")) void askToPersist();
}

/** State of the storage of this device; null where the browser does not tell. */
export interface StorageState {
  readonly persisted: boolean | null;
  /** Bytes. */
  readonly used: number | null;
  readonly quota: number | null;
}

export async function storageState(): Promise<StorageState> {
  try {
    const [persisted, size] = await Promise.all([storage()?.persisted(), storage()?.estimate()]);
    return { persisted: persisted ?? null, used: size?.usage ?? null, quota: size?.quota ?? null };
  } catch {
    return { persisted: null, used: null, quota: null };
  }
}
