/*
 * Effects whose answers come later: from the worker, the device or a part that is fetched. Nobody waits for them any
 * more once what asked has changed or is gone.
 */

/**
 * Begins work with several answers, which asks after each whether to go on. `pause`: before it begins, ms; at once
 * without. Returns the function that ends it, the cleanup of an effect.
 */
export function untilGone(work: (isGone: () => boolean) => Promise<void>, pause?: number): () => void {
  let gone = false;
  const begin = () => void work(() => gone);
  const timer = pause === undefined ? undefined : setTimeout(begin, pause);
  if (pause === undefined) begin();
  return () => {
    gone = true;
    clearTimeout(timer);
  };
}

/** The same for one answer. */
export const takeAnswer = <T>(ask: () => Promise<T>, take: (answer: T) => void, pause?: number): (() => void) =>
  untilGone(async (isGone) => {
    const answer = await ask();
    if (!isGone()) take(answer);
  }, pause);
