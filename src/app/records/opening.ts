import { storedText } from "../base/storage.ts";

/*
 * A work may break the page: an endless loop, a browser out of memory. A mark stands on the device from the moment that
 * a work is opened or changed until its result is shown. A page that finds the mark of a work which no tab has open
 * knows that the last one died over it.
 */

const PREFIX = "opening/";
const mark = (work: string) => storedText(PREFIX + work);

/** Works marked by this page. */
const marked = new Set<string>();
/** Works over which the page has failed: their marks outlast it. */
const broken = new Set<string>();

/** Marks a work before it is opened or calculated. */
export function noteOpening(work: string): void {
  if (marked.has(work)) return;
  marked.add(work);
  mark(work).set("1");
}

/** Removes the marks of this page: its works are shown, or it closes in good order. */
export function noteShown(): void {
  for (const work of marked) if (!broken.has(work)) mark(work).set(null);
  marked.clear();
}

/** The page has failed over a work. */
export function noteBroken(work: string): void {
  broken.add(work);
  mark(work).set("1");
}

/** Whether a page died while a work was opened or calculated. */
export const diedOpen = (work: string): boolean => !marked.has(work) && mark(work).get() === "1";

/** Removes the mark of a work that is deleted. */
export function forgetMark(work: string): void {
  marked.delete(work);
  mark(work).set(null);
}
