import { useSyncExternalStore } from "react";
import { changes } from "./changes.ts";
import { rememberingLast } from "./once.ts";

/** The root font size that the style sheets are written for, pixels. */
const WRITTEN_FOR = 16;

/** Events that change the font size of the page. */
const letters = changes((changed) => {
  addEventListener("resize", changed);
  new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-size"] });
});

const unitAfter = rememberingLast((_changes: number): number => {
  const size = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  return size > 0 ? size / WRITTEN_FOR : 1;
});

/**
 * Scale of the page: 1 on usual screens, more on large ones and in the presentation size. It is read once between two
 * changes, since the browser computes the styles of the whole page for it.
 */
export const pageUnit = (): number => (typeof document === "undefined" ? 1 : unitAfter(letters.count()));

/** The same as a hook, for drawings in pixels that scale with the page. */
export const usePageUnit = (): number => useSyncExternalStore(letters.subscribe, pageUnit, () => 1);
