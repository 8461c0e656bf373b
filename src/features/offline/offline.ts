import { time } from "../../app/base/clock.ts";
import { flushEdits } from "../../app/document/store.ts";
import { useVersion } from "../../app/base/version.ts";

/** An open page checks for a newer version when it becomes visible, at most this often, ms. */
const UPDATE_CHECK_INTERVAL = 3_600_000;

let registration: ServiceWorkerRegistration | null = null;

/** Reports the progress of a pending version. */
function followInstall(worker: ServiceWorker): void {
  const now = () => {
    const others = registration?.active && registration.active !== worker;
    if (worker.state === "installed" && others) useVersion.setState({ newer: "ready", later: false, looked: "no" });
    if (worker.state === "activated") useVersion.setState({ kept: "kept" });
    if (worker.state !== "redundant") return;
    const { kept, newer, looked } = useVersion.getState();
    if (!registration?.active) useVersion.setState({ kept: kept === "kept" ? kept : "failed" });
    else if (newer === "none" && looked === "coming") useVersion.setState({ looked: "unfinished" });
  };
  worker.addEventListener("statechange", now);
  now();
}

/** Stores the page, or resumes an interrupted download. */
async function register(): Promise<void> {
  try {
    registration = await navigator.serviceWorker.register(new URL("sw.js", document.baseURI), {
      updateViaCache: "none",
    });
  } catch {
    registration = (await navigator.serviceWorker.getRegistration().catch(() => undefined)) ?? null;
  }
  if (!registration) return useVersion.setState({ kept: "failed" });
  useVersion.setState({ kept: registration.active ? "kept" : "coming" });
  registration.onupdatefound = () => registration?.installing && followInstall(registration.installing);
  for (const worker of [registration.installing, registration.waiting]) if (worker) followInstall(worker);
}

/** Checks for a newer version on the server. It is downloaded completely before it is announced. */
export async function checkForUpdate(): Promise<void> {
  useVersion.setState({ looked: "looking", lookedAt: time() });
  try {
    if (!registration?.active) await register();
    else await registration.update();
    const found = registration?.installing ?? registration?.waiting;
    if (useVersion.getState().looked !== "looking") return;
    if (found && found === registration?.waiting) useVersion.setState({ newer: "ready", looked: "no" });
    else useVersion.setState({ looked: found ? "coming" : registration ? "newest" : "unreachable" });
  } catch {
    useVersion.setState({ looked: "unreachable" });
  }
}

/** Activates the newer version and reloads the page; flushes buffered edits first, as on every reload. */
export function applyUpdate(): void {
  flushEdits();
  const waiting = registration?.waiting;
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  waiting.postMessage("take over");
}

/**
 * From now on the page is stored on the device, and newer versions are noticed. Nothing here reloads the page by
 * itself.
 */
export async function startOffline(): Promise<void> {
  const { serviceWorker: container } = navigator;
  let cared = container.controller !== null;
  container.addEventListener("controllerchange", () => {
    // The first worker takes control of a page that came from the network.
    if (cared) useVersion.setState({ newer: "elsewhere", later: false });
    cared = true;
  });
  await register();
  useVersion.setState({ lookedAt: time() });
  container.controller?.postMessage("tidy");
  addEventListener(
    "online",
    () => void (registration?.active ? registration.update().catch(() => undefined) : register()),
  );
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState !== "visible" || time() - useVersion.getState().lookedAt < UPDATE_CHECK_INTERVAL)
      return;
    useVersion.setState({ lookedAt: time() });
    void registration?.update().catch(() => undefined);
  });
}
