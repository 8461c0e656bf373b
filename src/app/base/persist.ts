import { keptText } from "./kept.ts";

/**
 * Notes on this device that the browser was asked to keep the works for good: it is asked once, and not again by
 * itself.
 */
const ASKED = keptText("persist");

const storage = (): StorageManager | undefined => (typeof navigator === "undefined" ? undefined : navigator.storage);

/** Asks the browser to keep what lies on the device for good; false when it does not promise that. */
export async function askToPersist(): Promise<boolean> {
  try {
    return (await storage()?.persist()) ?? false;
  } catch {
    return false;
  }
}

/** Asks once, when the first work was kept: then there is something to lose. */
export function persistOnce(): void {
  if (ASKED.get() === null && ASKED.set("asked")) void askToPersist();
}

/** What is known of the storage of this device; null for what the browser does not say. */
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
