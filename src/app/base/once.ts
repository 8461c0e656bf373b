/** Makes something when it is first asked for; afterwards the same is given. */
export function once<T>(make: () => T): () => T {
  let made: { readonly value: T } | null = null;
  return () => (made ??= { value: make() }).value;
}

/** Keeps the newest result of a function: asked for the same again, it gives the same again. */
export function rememberingLast<A extends readonly unknown[], T>(make: (...of: A) => T): (...of: A) => T {
  let last: { readonly of: A; readonly value: T } | null = null;
  return (...of) => {
    if (!last?.of.every((each, i) => Object.is(each, of[i]))) last = { of, value: make(...of) };
    return last.value;
  };
}

/** Runs a job that is never done twice at once: asked while it runs, it gives the promise of that run. */
export function oneAtATime(job: () => Promise<void>): () => Promise<void> {
  let running: Promise<void> | null = null;
  return () =>
    (running ??= job().finally(() => {
      running = null;
    }));
}

/** Numbers that no two callers share: 1, 2, … */
export function counter(): () => number {
  let last = 0;
  return () => ++last;
}

/** Of several beginnings only the newest counts: each gives the way to ask whether it still is that. */
export function onlyNewest(): () => () => boolean {
  let count = 0;
  return () => {
    count += 1;
    const own = count;
    return () => own === count;
  };
}

/** One timer: what it is started with replaces what it waited for. */
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
