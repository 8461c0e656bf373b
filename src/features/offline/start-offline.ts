import { scheduleIdle } from "../../app/base/idle.ts";
import { canKeep, useVersion, type InstallOffer } from "../../app/base/version.ts";

/** Keeps the browser's offer to install for the settings, instead of a banner over the work. */
function holdInstallOffer(): void {
  addEventListener("beforeinstallprompt", (event) => {
    event.preventDefault();
    useVersion.setState({ install: event as InstallOffer });
  });
  addEventListener("appinstalled", () => useVersion.setState({ install: null }));
}

/**
 * Stores the page on the device when the browser is idle, so that the first visit never waits. From the start, the page
 * holds a lock with its version, so that its parts are not removed while it is open.
 */
export function scheduleOfflineStart(): void {
  if (!canKeep) return;
  holdInstallOffer();
  const script = document.querySelector<HTMLScriptElement>("script[type=module][src]")?.src ?? "";
  void navigator.locks
    ?.request(`turnwise page ${script}`, { mode: "shared" }, () => new Promise<void>(() => undefined))
    .catch(() => undefined);
  const start = () =>
    void import("./offline.ts")
      .then(({ startOffline }) => startOffline())
      .catch(() => addEventListener("online", start, { once: true }));
  const soon = () => void scheduleIdle(start);
  if (document.readyState === "complete") soon();
  else addEventListener("load", soon, { once: true });
}
