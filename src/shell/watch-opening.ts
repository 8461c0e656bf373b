import { useOutcome } from "../app/calculation/outcome.ts";
import { useEditor } from "../app/document/store.ts";
import { afterPaint } from "../app/base/typing.ts";
import { restartable } from "../app/base/once.ts";
import { OPENING } from "../app/base/waits.ts";
import { noteShown } from "../app/records/opening.ts";

/**
 * Removes the mark of the open work once its result is drawn, or the page has lived on without one. A hidden page may be
 * ended by the system at any time, which is no fault of the work.
 */
export function watchOpening(): () => void {
  const timer = restartable();
  let before = useOutcome.getState().newest;
  const isSettled = () => {
    const { newest, stage, paused, stopped } = useOutcome.getState();
    return stage === null && (newest !== before || paused || stopped);
  };
  const stops = [
    useEditor.subscribe(() => {
      before = useOutcome.getState().newest;
      timer.start(noteShown, OPENING.withoutResult);
    }),
    useOutcome.subscribe(() => {
      if (isSettled()) afterPaint(() => isSettled() && timer.start(noteShown, OPENING.drawn));
    }),
  ];
  const hide = () => {
    if (document.visibilityState === "hidden") noteShown();
  };
  addEventListener("pagehide", noteShown);
  document.addEventListener("visibilitychange", hide);
  return () => {
    for (const stop of stops) stop();
    timer.stop();
    removeEventListener("pagehide", noteShown);
    document.removeEventListener("visibilitychange", hide);
  };
}
