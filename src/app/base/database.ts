import { createStore, del, entries, get, keys, set, setMany } from "idb-keyval";

/** Timeouts of the storage, ms: reading, so that the page opens even if it never answers, and writing a large work. */
const PATIENCE = { read: 4000, write: 15_000 };

/** The first call without an answer; while it is pending, all others fail at once. */
let unanswered: Promise<unknown> | null = null;
const hearers = new Set<() => void>();

/** Whether the storage has not answered in time, and still has not. */
export const isSilent = (): boolean => unanswered !== null;

/** Calls back when a storage that did not answer in time answers after all. */
export const onLateAnswer = (hear: () => void): void => void hearers.add(hear);

/** Asks the storage. Rejects where it does not answer in time, as one that is blocked, refused or broken. */
function inTime<T>(patience: number, ask: () => Promise<T>): Promise<T> {
  if (unanswered) return Promise.reject(new Error("the storage has not answered"));
  const answer = ask();
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => {
      if (!unanswered) {
        unanswered = answer;
        const end = () => {
          unanswered = null;
          for (const hear of hearers) hear();
        };
        answer.then(end, end);
      }
      reject(new Error("no answer from the storage"));
    }, patience);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/**
 * A table in an IndexedDB database of the same name. It is opened on first use; any call may fail where the browser
 * refuses or does not answer.
 */
export function database(name: string) {
  const store = createStore(`turnwise-${name}`, name);
  const reading = <T>(ask: () => Promise<T>) => inTime(PATIENCE.read, ask);
  const writing = <T>(ask: () => Promise<T>) => inTime(PATIENCE.write, ask);
  return {
    get: <T>(key: string) => reading(() => get<T>(key, store)),
    set: (key: string, value: unknown) => writing(() => set(key, value, store)),
    setMany: (all: [string, unknown][]) => writing(() => setMany(all, store)),
    del: (key: string) => writing(() => del(key, store)),
    keys: () => reading(() => keys<string>(store)),
    entries: () => reading(() => entries<string, unknown>(store)),
  };
}
