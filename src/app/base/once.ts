/** Makes a value on the first call and returns the same one afterwards. */
export function once<T>(make: () => T): () => T {
  let made: { readonly value: T } | null = null;
  return () => (made ??= { value: make() }).value;
}

/** Caches the last result of a function: the same arguments return the same result. */
export function rememberingLast<A extends readonly unknown[], T>(make: (...of: A) => T): (...of: A) => T {
  let last: { readonly of: A; readonly value: T } | null = null;
  return (...of) => {
    if (!last?.of.every((each, i) => Object.is(each, of[i]))) last = { of, value: make(...of) };
    return last.value;
  };
}

/** Runs a job never twice at once: a call during a run returns the promise of that run. */
export function oneAtATime(job: () => Promise<void>): () => Promise<void> {
  let running: Promise<void> | null = null;
  return () =>
    (running ??= job().finally(() => {
      running = null;
    }));
}

/** Whole numbers of a source, each greater than the one before. */
export function increasing(source: () => number): () => number {
  let last = 0;
  return () => (last = Math.max(source(), last + 1));
}

/** Numbers that never repeat: 1, 2, … */
export function counter(): () => number {
  let last = 0;
  return () => ++last;
}

/** Each call starts a new run and returns a check whether that run is still the newest. */
export function onlyNewest(): () => () => boolean {
  let count = 0;
  return () => {
    count += 1;
    const own = count;
    return () => own === count;
  };
}

/** One timer: a new start replaces the pending one. */
export function restartable(): { start(run: () => void, ms?: number): void; stop(): void } {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = () => clearTimeout(timer);
  return {
    stop,
    start(run, ms) {
      stop();
      timer = setTimeout(run, ms);
    },
  };
}
