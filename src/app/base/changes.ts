import { once } from "./once.ts";

/** A counted source of changes of the page, for values that are derived from it. */
export interface Changes {
  subscribe(listener: () => void): () => void;
  /** Number of changes since the first call. */
  count(): number;
}

/** `watch` is called on first use, and then calls back with every change. */
export function changes(watch: (changed: () => void) => void): Changes {
  let count = 0;
  const listeners = new Set<() => void>();
  const start = once(() =>
    watch(() => {
      count += 1;
      for (const listener of [...listeners]) listener();
    }),
  );
  return {
    subscribe(listener) {
      start();
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    count() {
      start();
      return count;
    },
  };
}
