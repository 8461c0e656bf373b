import { createStore, del, entries, get, keys, set, setMany } from "idb-keyval";

/**
 * A table in an IndexedDB database of the same name. It is opened on first use; any call may fail where the browser
 * refuses.
 */
export function database(name: string) {
  const store = createStore(`turnwise-${name}`, name);
  return {
    get: <T>(key: string) => get<T>(key, store),
    set: (key: string, value: unknown) => set(key, value, store),
    setMany: (all: [string, unknown][]) => setMany(all, store),
    del: (key: string) => del(key, store),
    keys: () => keys<string>(store),
    entries: () => entries<string, unknown>(store),
  };
}
