import { useEffect } from "react";
import { showMade } from "./play-made.ts";
import { useTaskView } from "./task-view.ts";

/** After a check that passes, the assignment is folded and the picture shows what was made. */
export function useShowPassed(): void {
  useEffect(
    () =>
      useTaskView.subscribe(({ checked }, before) => {
        if (checked === before.checked || !checked?.passed) return;
        useTaskView.setState({ open: false });
        showMade();
      }),
    [],
  );
}
