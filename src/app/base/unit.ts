import { useSyncExternalStore } from "react";

/** The root font size that the style sheets are written for, pixels. */
const WRITTEN_FOR = 16;

let known: number | null = null;
const listeners = new Set<() => void>();
let watching = false;

/** From now on what changes the letters of the page is noticed. */
function watch(): void {
  if (watching) return;
  watching = true;
  const change = () => {
    known = null;
    for (const listener of [...listeners]) listener();
  };
  addEventListener("resize", change);
  new MutationObserver(change).observe(document.documentElement, { attributeFilter: ["data-size"] });
}

/**
 * How much larger than written the page is shown: 1 on usual screens, more on large ones and in the presentation size. It is asked for once
 * between two changes: the browser works out the styles of the whole page to tell it.
 */
export function pageUnit(): number {
  if (typeof document === "undefined") return 1;
  watch();
  if (known !== null) return known;
  const size = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  known = size > 0 ? size / WRITTEN_FOR : 1;
  return known;
}

function subscribe(listener: () => void): () => void {
  watch();
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** The same, followed: for what is drawn in pixels and has to grow with the page. */
export const usePageUnit = (): number => useSyncExternalStore(subscribe, pageUnit, () => 1);
