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

/** A length of a drawing, units of the page, as a style. */
export const pageLength = (units: number): string => `${units / WRITTEN_FOR}rem`;

/** A place on the page, CSS pixels, in units of the page from the upper left corner of an element. */
export function placeIn(element: Element, { clientX, clientY }: Pick<MouseEvent, "clientX" | "clientY">) {
  const { left, top } = element.getBoundingClientRect(),
    unit = pageUnit();
  return { x: (clientX - left) / unit, y: (clientY - top) / unit };
}

/** The inner size of an element, units of the page. */
export function sizeOf({ clientWidth, clientHeight }: Element) {
  const unit = pageUnit();
  return { width: clientWidth / unit, height: clientHeight / unit };
}

/** The same as a hook, for drawings in pixels that scale with the page. */
export const usePageUnit = (): number => useSyncExternalStore(letters.subscribe, pageUnit, () => 1);
