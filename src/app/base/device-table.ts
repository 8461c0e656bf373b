import type { StoreApi } from "zustand";

/** A table that the device keeps, and that all tabs share. */
export interface DeviceTable<L> {
  /** Where it is kept, and where a text is set aside that cannot be read. */
  readonly key: string;
  readonly aside: string;
  readonly store: Pick<StoreApi<{ readonly list: L }>, "getState" | "subscribe">;
  /** What stands there when nothing is kept. */
  readonly first: L;
  readonly isSame: (a: L, b: L) => boolean;
  /** The text that is kept; null where there is nothing to keep. */
  readonly write: (list: L) => string | null;
  /** A kept table, or null when it is damaged. Never throws. */
  readonly read: (kept: string) => L | null;
  readonly take: (list: L) => void;
  /** Says that a table was damaged, and that the device does not take one. */
  readonly damaged: () => void;
  readonly notKept: () => void;
}

/** Rest before writing, ms. */
const REST = 80;

/** Takes over what the device holds. What cannot be read is set aside. */
function takeOver<L>(table: DeviceTable<L>, kept: string | null): void {
  const list = kept === null ? table.first : table.read(kept);
  if (list !== null) {
    if (!table.isSame(list, table.store.getState().list)) table.take(list);
    return;
  }
  table.damaged();
  try {
    localStorage.setItem(table.aside, kept ?? "");
    localStorage.removeItem(table.key);
  } catch {
    return;
  }
}

/** Reads a table of this device and keeps each change from now on: what one tab changes the others take over. */
export function keepTable<L>(table: DeviceTable<L>): () => void {
  const { key, store } = table;
  try {
    takeOver(table, localStorage.getItem(key));
  } catch {
    return () => undefined;
  }
  let timer: ReturnType<typeof setTimeout> | undefined;
  let written = store.getState().list;
  const write = () => {
    clearTimeout(timer);
    timer = undefined;
    const { list } = store.getState();
    if (list === written) return;
    written = list;
    try {
      const kept = table.write(list);
      if (kept === null) localStorage.removeItem(key);
      else localStorage.setItem(key, kept);
    } catch {
      table.notKept();
    }
  };
  const fromOtherTab = (event: StorageEvent) => {
    if (event.storageArea !== localStorage || (event.key !== key && event.key !== null)) return;
    takeOver(table, event.newValue);
    written = store.getState().list;
  };
  const stop = store.subscribe(() => {
    timer ??= setTimeout(write, REST);
  });
  addEventListener("storage", fromOtherTab);
  addEventListener("pagehide", write);
  document.addEventListener("visibilitychange", write);
  return () => {
    write();
    stop();
    removeEventListener("storage", fromOtherTab);
    removeEventListener("pagehide", write);
    document.removeEventListener("visibilitychange", write);
  };
}
