import { retryImport } from "../base/parts.ts";
import { scheduleIdle } from "../base/idle.ts";
import { useEditor, openContent } from "../document/store.ts";

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
  const stop = useEditor.subscribe((now) => openContent(now) && start());
  const notYet = scheduleIdle(start);
  if (openContent()) start();
}
