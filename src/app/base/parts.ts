import { lazy } from "react";
import { create } from "zustand";
import { oneAtATime } from "./once.ts";

/*
 * Parts of the page are fetched when they are first needed. One may not come: there is no network and the page is not
 * yet kept on the device, or the server has a newer version and the old part is gone. That is said above what is open,
 * and never ends anything.
 */

/** Whether a part is missed, and why: no network, or a server that does not have it. */
export const useMissing = create<{ readonly missing: "no" | "offline" | "gone" }>(() => ({ missing: "no" }));

/** What Chromium, Firefox, Safari and Vite say of a script or style that did not come. */
const NOT_HERE = /dynamically imported module|importing a module script|unable to preload css/i;
/** True for the failure of a part that did not come. */
export const isMissing = (error: unknown): boolean => error instanceof Error && NOT_HERE.test(error.message);

/** Those who wait for a part that did not come. */
const waiting = new Set<() => void>();

/** The service worker's own script is the one file that is always asked of the server. */
const answers = (): Promise<boolean> =>
  fetch(new URL("sw.js", document.baseURI), { method: "HEAD", cache: "no-store" }).then(
    ({ ok }) => ok,
    () => false,
  );

/** Says that something did not come. */
function miss(): void {
  const { missing } = useMissing.getState();
  if (missing === "no") useMissing.setState({ missing: "offline" });
  void answers().then((online) =>
    useMissing.setState((now) => (now.missing === "no" ? now : { missing: online ? "gone" : "offline" })),
  );
}

/** Puts the notice away. Who waits goes on waiting. */
export const dismissMissing = (): void => useMissing.setState({ missing: "no" });

/** Style sheets that did not come. */
const broken = new Set<HTMLLinkElement>();

function mended(link: HTMLLinkElement): Promise<unknown> {
  const fresh = link.cloneNode() as HTMLLinkElement;
  return new Promise((done, fail) => {
    fresh.onload = done;
    fresh.onerror = () => fail(new Error(`Unable to preload CSS for ${fresh.href}`));
    link.replaceWith(fresh);
  });
}

/** Style sheets are asked for again here: Vite asks once for each, and a part would come without its own. */
const mendStyles = oneAtATime(async () => {
  const links = [...broken];
  broken.clear();
  await Promise.all(links.map(mended));
});

/** Asks again for everything that somebody waits for. */
export function fetchMissing(): void {
  dismissMissing();
  const all = [...waiting];
  waiting.clear();
  for (const goOn of all) goOn();
}

/**
 * The part, however long it takes: what does not come is said, and fetched again when there is a network or somebody
 * asks.
 */
export async function untilHere<T>(fetchPart: () => Promise<T>): Promise<T> {
  for (;;) {
    try {
      await mendStyles();
      return await fetchPart();
    } catch (error) {
      if (!isMissing(error)) throw error;
      const again = new Promise<void>((goOn) => waiting.add(goOn));
      miss();
      await again;
    }
  }
}

/**
 * A component that is fetched when it is first shown. All of them are made here, so that none can fail by not coming.
 */
export const lazyPart: typeof lazy = (fetchPart) => lazy(() => untilHere(fetchPart));

/** From now on what a press needs and does not get is said. The press itself is over: it may be made again. */
export function followMissing(): void {
  addEventListener("unhandledrejection", (event) => {
    if (!isMissing(event.reason)) return;
    event.preventDefault();
    miss();
  });
  addEventListener("online", fetchMissing);
  addEventListener(
    "error",
    ({ target }) => {
      if (target instanceof HTMLLinkElement && target.rel === "stylesheet") broken.add(target);
    },
    true,
  );
}
