import { startTransition } from "react";

/** What is done when the next picture is painted, all of it together. */
let waiting: readonly (() => void)[] = [];

/** A message comes behind the painting; a timer that is set with it would come before. */
const painted = new MessageChannel();
painted.port1.onmessage = () => {
  const due = waiting;
  waiting = [];
  startTransition(() => due.forEach((each) => each()));
};

/**
 * Runs when the next picture is painted, soon where none is: nobody looks at a hidden page. Gives the way to call it
 * off.
 */
export function afterPicture(run: () => void): () => void {
  const tell = () => painted.port2.postMessage(null);
  if (waiting.length === 0) {
    if (document.hidden) tell();
    else requestAnimationFrame(tell);
  }
  waiting = [...waiting, run];
  return () => {
    waiting = waiting.map((each) => (each === run ? () => undefined : each));
  };
}
