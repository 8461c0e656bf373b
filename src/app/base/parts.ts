import { createElement, lazy, Suspense, type ComponentType, type FunctionComponent } from "react";
import { create } from "zustand";
import { oneAtATime } from "./once.ts";

/*
 * Parts of the page are fetched when they are first needed. A fetch may fail: there is no network and the page is not
 * yet stored on the device, or the server has a newer version and the old part is gone. A notice above the open work
 * says so; nothing else ends.
 */

/** Whether a part is missing, and why: no network, or a server that no longer has it. */
export const useMissing = create<{ readonly missing: "no" | "offline" | "gone" }>(() => ({ missing: "no" }));

/** Error messages of Chromium, Firefox, Safari and Vite for a script or style sheet that failed to load. */
const NOT_HERE = /dynamically imported module|importing a module script|unable to preload css/i;
/** True for the error of a failed import. */
export const isMissing = (error: unknown): boolean => error instanceof Error && NOT_HERE.test(error.message);

/** Retries of the imports that failed. */
const waiting = new Set<() => void>();

/** Asks for the service worker's script: the one file that always comes from the server. */
const answers = (): Promise<boolean> =>
  fetch(new URL("sw.js", document.baseURI), { method: "HEAD", cache: "no-store" }).then(
    ({ ok }) => ok,
    () => false,
  );

/** Announces that a part could not be loaded. */
function announceMissing(): void {
  const { missing } = useMissing.getState();
  if (missing === "no") useMissing.setState({ missing: "offline" });
  void answers().then((online) =>
    useMissing.setState((now) => (now.missing === "no" ? now : { missing: online ? "gone" : "offline" })),
  );
}

/** Removes the notice. Failed imports keep waiting for a retry. */
export const dismissMissing = (): void => useMissing.setState({ missing: "no" });

/** Links of style sheets that failed to load. */
const broken = new Set<HTMLLinkElement>();

function mended(link: HTMLLinkElement): Promise<unknown> {
  const fresh = link.cloneNode() as HTMLLinkElement;
  return new Promise((done, fail) => {
    fresh.onload = done;
    fresh.onerror = () => fail(new Error(`Unable to preload CSS for ${fresh.href}`));
    link.replaceWith(fresh);
  });
}

/** Loads failed style sheets again: Vite asks for each only once, and a part would appear unstyled. */
const mendStyles = oneAtATime(async () => {
  const links = [...broken];
  broken.clear();
  await Promise.all(links.map(mended));
});

/** Retries every failed import. */
export function fetchMissing(): void {
  dismissMissing();
  const all = [...waiting];
  waiting.clear();
  for (const goOn of all) goOn();
}

/**
 * The part, however long it takes: a failure is announced, and the fetch repeated when the network is back or somebody
 * asks for it.
 */
export async function retryImport<T>(fetchPart: () => Promise<T>): Promise<T> {
  for (;;) {
    try {
      await mendStyles();
      return await fetchPart();
    } catch (error) {
      if (!isMissing(error)) throw error;
      const again = new Promise<void>((goOn) => waiting.add(goOn));
      announceMissing();
      await again;
    }
  }
}

/**
 * A component that is fetched when it is first shown; the Suspense around it says what is in its place until then. All
 * of them are made here, so that none can fail by a failed import.
 */
export const lazyWithin: typeof lazy = (fetchPart) => lazy(() => retryImport(fetchPart));

/** The same in a Suspense of its own: nothing is in its place until it and its texts are here. */
export function lazyPart<Props extends object>(
  fetchPart: () => Promise<{ default: ComponentType<Props> }>,
): FunctionComponent<Props> {
  const Part: ComponentType<Props> = lazyWithin(fetchPart);
  return (props) => createElement(Suspense, null, createElement(Part, props));
}

/** Announces failed imports that follow a click. They are not retried: the click can be repeated. */
export function followMissing(): void {
  addEventListener("unhandledrejection", (event) => {
    if (!isMissing(event.reason)) return;
    event.preventDefault();
    announceMissing();
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
