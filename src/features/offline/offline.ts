import { time } from "../../app/base/clock.ts";
import { handOver } from "../../app/document/store.ts";
import { useVersion } from "../../app/base/version.ts";

/** A page that stays open looks for a newer version when it is come back to, not more often than this, ms. */
const LOOK_AGAIN = 3_600_000;

let registration: ServiceWorkerRegistration | null = null;

/** Says what becomes of a version that is on its way. */
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

/** Keeps the page, or goes on with that where it was broken off. */
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

/** Looks whether the server has a newer version. It is fetched whole before anything is said of it. */
export async function lookForNewer(): Promise<void> {
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

/**
 * Puts the newer version in use and loads the page again; what is typed is handed over first, and kept as on every
 * reload.
 */
export function updateNow(): void {
  handOver();
  const waiting = registration?.waiting;
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  waiting.postMessage("take over");
}

/**
 * From now on the page is kept on the device, and newer versions are noticed. Nothing here loads the page by itself.
 */
export async function startOffline(): Promise<void> {
  const { serviceWorker: container } = navigator;
  let cared = container.controller !== null;
  container.addEventListener("controllerchange", () => {
    // The first one takes a page into its care that came from the network.
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
    if (document.visibilityState !== "visible" || time() - useVersion.getState().lookedAt < LOOK_AGAIN) return;
    useVersion.setState({ lookedAt: time() });
    void registration?.update().catch(() => undefined);
  });
}
