import { once } from "./once.ts";

/** Something of the page that changes by itself, followed by what is worked out from it. */
export interface Changes {
  subscribe(listener: () => void): () => void;
  /** How many there were since the first question. */
  count(): number;
}

/** `watch` is called with the first question, and then calls back with every change. */
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
