import { cacheNames } from "workbox-core";
import { PrecacheController, PrecacheRoute, type PrecacheEntry } from "workbox-precaching";
import { registerRoute } from "workbox-routing";

/*
 * Stores the whole site on the device. A version is installed only as a whole: each file has to match the build's hash,
 * or the previous version stays in use. It takes over when no page of the older version is open, or on request.
 */

declare const self: ServiceWorkerGlobalScope;
/** The file list, injected by the build (scripts/offline.ts). */
declare const KEPT_FILES: PrecacheEntry[];

/** Files fetched in parallel. */
const MAX_PARALLEL = 4;

const controller = new PrecacheController();
controller.addToCacheList(KEPT_FILES);
// Files are identified by content, so the server's Vary headers do not matter.
controller.strategy.matchOptions = { ignoreVary: true };

type KeyedFile = readonly [url: string, cacheKey: string];

/** Fetches one file of the list, unless it is cached; rejects a file that does not match its hash. */
async function keepFile(event: ExtendableEvent, [url, cacheKey]: KeyedFile, cache: RequestCache): Promise<void> {
  const integrity = controller.getIntegrityForCacheKey(cacheKey) ?? "";
  const request = new Request(url, { integrity, cache, credentials: "same-origin", priority: "low" });
  await Promise.all(controller.strategy.handleAll({ params: { cacheKey, integrity }, request, event }));
}

type Trust = (file: KeyedFile) => RequestCache;
/** Files with a hash in their name may come from the HTTP cache. */
const trusting: Trust = ([url, cacheKey]) => (url === cacheKey ? "default" : "no-cache");

/** Fetches the missing files. Returns those that failed or do not match their hash. */
async function keepFiles(
  event: ExtendableEvent,
  wanted: readonly KeyedFile[],
  trust: Trust,
): Promise<readonly KeyedFile[]> {
  const waiting = [...wanted];
  const failed: KeyedFile[] = [];
  const work = async () => {
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      const wants = file;
      await keepFile(event, wants, trust(wants)).catch(() => failed.push(wants));
    }
  };
  await Promise.all(Array.from({ length: MAX_PARALLEL }, work));
  return failed;
}

/** The HTTP cache may hold an error page that a server returned for a missing file: the second try bypasses it. */
async function keepAll(event: ExtendableEvent): Promise<void> {
  const failed = await keepFiles(event, [...controller.getURLsToCacheKeys()], trusting);
  if (failed.length > 0 && (await keepFiles(event, failed, () => "reload")).length > 0)
    throw new Error("this version is not complete");
}

/**
 * Pages hold a lock named by their script address: whether one of an older version is open, and still needs its parts.
 */
async function hasOlderPages(): Promise<boolean> {
  if (!("locks" in self.navigator)) return false;
  const { held = [] } = await self.navigator.locks.query();
  const pages = held.flatMap(({ name = "" }) =>
    name.startsWith(`turnwise page ${self.registration.scope}`) ? [name.slice(14)] : [],
  );
  return pages.some((script) => !controller.getCacheKeyForURL(script));
}

/** Removes the files of older versions once no page needs them. */
async function removeOldFiles(event: ExtendableEvent): Promise<void> {
  if (!(await hasOlderPages())) await controller.activate(event);
}

self.addEventListener("install", (event) => event.waitUntil(keepAll(event)));
self.addEventListener("activate", (event) =>
  event.waitUntil(Promise.all([removeOldFiles(event), self.clients.claim()])),
);
self.addEventListener("message", (event) => {
  if (event.data === "take over") event.waitUntil(self.skipWaiting());
  if (event.data === "tidy") event.waitUntil(removeOldFiles(event));
});

registerRoute(new PrecacheRoute(controller, { ignoreURLParametersMatching: [/./], cleanURLs: false }));
// An open page of the previous version fetches its own parts.
registerRoute(
  ({ url }) => url.href.startsWith(`${self.registration.scope}assets/`),
  async ({ request }) =>
    (await caches.match(request.url, { cacheName: cacheNames.precache, ignoreVary: true })) ?? fetch(request),
);
