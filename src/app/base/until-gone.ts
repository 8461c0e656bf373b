/*
 * Effects whose answers come later: from the worker, the device or a part that is fetched. Nobody waits for them any
 * more once what asked has changed or is gone.
 */

/** When work begins: after a pause, ms, or when it is called, until it is cancelled. */
type Begin = number | ((begin: () => void) => () => void);

const NEVER_MIND = () => undefined;
const atOnce: Begin = (begin) => {
  begin();
  return NEVER_MIND;
};

/**
 * Begins work with several answers, which asks after each whether to go on. Returns the function that ends it, the
 * cleanup of an effect.
 */
export function untilGone(work: (isGone: () => boolean) => Promise<void>, when: Begin = atOnce): () => void {
  let gone = false;
  const begin = () => void work(() => gone);
  const timer = typeof when === "number" ? setTimeout(begin, when) : undefined,
    cancel = typeof when === "number" ? NEVER_MIND : when(begin);
  return () => {
    gone = true;
    clearTimeout(timer);
    cancel();
  };
}

/** The same for one answer. */
export const takeAnswer = <T>(ask: () => Promise<T>, take: (answer: T) => void, when?: Begin): (() => void) =>
  untilGone(async (isGone) => {
    const answer = await ask();
    if (!isGone()) take(answer);
  }, when);
