import { atRest } from "../../app/base/rest.ts";
import { canKeep } from "../../app/base/version.ts";

/**
 * Keeps the page on the device once it is shown and the browser rests: the first visit waits for none of it. From the
 * beginning this page says by a lock which version it is, so that its parts are not cleared away while it is open.
 */
export function startOfflineLater(): void {
  if (!canKeep) return;
  const script = document.querySelector<HTMLScriptElement>("script[type=module][src]")?.src ?? "";
  void navigator.locks
    ?.request(`turnwise page ${script}`, { mode: "shared" }, () => new Promise<void>(() => undefined))
    .catch(() => undefined);
  const start = () =>
    void import("./offline.ts")
      .then(({ startOffline }) => startOffline())
      .catch(() => addEventListener("online", start, { once: true }));
  const soon = () => void atRest(start);
  if (document.readyState === "complete") soon();
  else addEventListener("load", soon, { once: true });
}
