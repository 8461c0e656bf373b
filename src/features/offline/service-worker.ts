import { cacheNames } from "workbox-core";
import { PrecacheController, PrecacheRoute, type PrecacheEntry } from "workbox-precaching";
import { registerRoute } from "workbox-routing";

/*
 * Keeps the whole site on the device. A version is taken only as a whole: each file has to be the one that the build
 * made, or the version before stays in use. It takes over when no page of the older version is open, or when somebody
 * asks for it.
 */

declare const self: ServiceWorkerGlobalScope;
/** The list of the site, put in by the build (scripts/offline.ts). */
declare const KEPT_FILES: PrecacheEntry[];

/** Files that are on their way at the same time. */
const AT_ONCE = 4;

const controller = new PrecacheController();
controller.addToCacheList(KEPT_FILES);
// What a server says of encodings and origins makes no difference to files that are known by their content.
controller.strategy.matchOptions = { ignoreVary: true };

type KeyedFile = readonly [url: string, cacheKey: string];

/** Fetches one file of the list, unless it is here already: one that is not what the list says is refused. */
async function keepFile(event: ExtendableEvent, [url, cacheKey]: KeyedFile, cache: RequestCache): Promise<void> {
  const integrity = controller.getIntegrityForCacheKey(cacheKey) ?? "";
  const request = new Request(url, { integrity, cache, credentials: "same-origin", priority: "low" });
  await Promise.all(controller.strategy.handleAll({ params: { cacheKey, integrity }, request, event }));
}

type Trust = (file: KeyedFile) => RequestCache;
/** What bears its content in its name may come out of the browser's own store. */
const trusting: Trust = ([url, cacheKey]) => (url === cacheKey ? "default" : "no-cache");

/** Fetches what is missing. Gives what did not come or is not what the list says. */
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
  await Promise.all(Array.from({ length: AT_ONCE }, work));
  return failed;
}

/**
 * What lies in the browser's own store may be a page that a server gave in place of a missing file: the second time it
 * is passed by.
 */
async function keepAll(event: ExtendableEvent): Promise<void> {
  const failed = await keepFiles(event, [...controller.getURLsToCacheKeys()], trusting);
  if (failed.length > 0 && (await keepFiles(event, failed, () => "reload")).length > 0)
    throw new Error("this version is not complete");
}

/**
 * Pages hold a lock with the address of their script: whether one of an older version is open, whose parts are still
 * wanted.
 */
async function olderPages(): Promise<boolean> {
  if (!("locks" in self.navigator)) return false;
  const { held = [] } = await self.navigator.locks.query();
  const pages = held.flatMap(({ name = "" }) =>
    name.startsWith(`turnwise page ${self.registration.scope}`) ? [name.slice(14)] : [],
  );
  return pages.some((script) => !controller.getCacheKeyForURL(script));
}

/** Removes the files of older versions once no page needs them. */
async function tidy(event: ExtendableEvent): Promise<void> {
  if (!(await olderPages())) await controller.activate(event);
}

self.addEventListener("install", (event) => event.waitUntil(keepAll(event)));
self.addEventListener("activate", (event) => event.waitUntil(Promise.all([tidy(event), self.clients.claim()])));
self.addEventListener("message", (event) => {
  if (event.data === "take over") event.waitUntil(self.skipWaiting());
  if (event.data === "tidy") event.waitUntil(tidy(event));
});

registerRoute(new PrecacheRoute(controller, { ignoreURLParametersMatching: [/./], cleanURLs: false }));
// A page of the version before, still open, fetches its own parts.
registerRoute(
  ({ url }) => url.href.startsWith(`${self.registration.scope}assets/`),
  async ({ request }) =>
    (await caches.match(request.url, { cacheName: cacheNames.precache, ignoreVary: true })) ?? fetch(request),
);
