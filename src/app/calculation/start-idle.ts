import { retryImport } from "../base/parts.ts";
import { scheduleIdle } from "../base/idle.ts";
import { useEditor } from "../document/store.ts";

/**
 * Starts the calculation when a work is open, or else when the browser is idle: the first screen does not wait for its
 * code.
 */
export function startCalculationIdle(): void {
  let started = false;
  const start = () => {
    if (started) return;
    started = true;
    stop();
    notYet();
    void retryImport(() => import("./calculation.ts")).then(({ calculation }) => calculation.start());
  };
  const isOpen = ({ job, program }: ReturnType<typeof useEditor.getState>) => job !== null || program !== null;
  const stop = useEditor.subscribe((now) => isOpen(now) && start());
  const notYet = scheduleIdle(start);
  if (isOpen(useEditor.getState())) start();
}
