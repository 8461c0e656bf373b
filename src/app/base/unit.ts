import { useSyncExternalStore } from "react";
import { changes } from "./changes.ts";
import { rememberingLast } from "./once.ts";

/** The root font size that the style sheets are written for, pixels. */
const WRITTEN_FOR = 16;

/** What changes the letters of the page. */
const letters = changes((changed) => {
  addEventListener("resize", changed);
  new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-size"] });
});

const unitAfter = rememberingLast((_changes: number): number => {
  const size = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  return size > 0 ? size / WRITTEN_FOR : 1;
});

/**
 * How much larger than written the page is shown: 1 on usual screens, more on large ones and in the presentation size.
 * It is asked for once between two changes: the browser works out the styles of the whole page to tell it.
 */
export const pageUnit = (): number => (typeof document === "undefined" ? 1 : unitAfter(letters.count()));

/** The same, followed: for what is drawn in pixels and has to grow with the page. */
export const usePageUnit = (): number => useSyncExternalStore(letters.subscribe, pageUnit, () => 1);
