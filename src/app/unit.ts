import { useSyncExternalStore } from "react";

/** The root font size that the style sheets are written for, pixels. */
const WRITTEN_FOR = 16;

/** How much larger than written the page is shown: 1 on usual screens, more on large ones and in the presentation size. */
export function pageUnit(): number {
  if (typeof document === "undefined") return 1;
  const size = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  return size > 0 ? size / WRITTEN_FOR : 1;
}

function subscribe(listener: () => void): () => void {
  addEventListener("resize", listener);
  const attributes = new MutationObserver(listener);
  attributes.observe(document.documentElement, { attributeFilter: ["data-size"] });
  return () => {
    removeEventListener("resize", listener);
    attributes.disconnect();
  };
}

/** The same, followed: for what is drawn in pixels and has to grow with the page. */
export const usePageUnit = (): number => useSyncExternalStore(subscribe, pageUnit, () => 1);
