import type { KeyboardEvent } from "react";

const ROW = ".cycle-take";
/** Parts of the chooser; a page may show something else between them. */
const OWN = ".cycle-search, .recent-cycles, .cycle-group, .cycle-row";
const isText = (key: string) => key.length === 1 && key !== " " && key !== "?";

/** Elements whose edges differ by less than this stand in one line, px. */
const SAME_LINE = 24;

/** The element of the nearest line in a direction that is most nearly aligned. */
function nearest(from: DOMRect, all: readonly HTMLElement[], down: boolean): HTMLElement | undefined {
  const far = (box: DOMRect) => (down ? box.top - from.bottom : from.top - box.bottom);
  const aside = (box: DOMRect) => Math.abs(box.left - from.left);
  /** Neighbours may overlap by the width of a line, px. */
  const beyond = all
    .map((element) => [element, element.getBoundingClientRect()] as const)
    .filter(([, box]) => far(box) > -2);
  const nearestLine = Math.min(...beyond.map(([, box]) => far(box)));
  const line = beyond.filter(([, box]) => far(box) < nearestLine + SAME_LINE);
  const [best] = line.sort(([, a], [, b]) => aside(a) - aside(b));
  return best?.[0];
}

/**
 * Arrow keys in the chooser: up and down between rows and groups, left and right between the buttons of the rows.
 * Letters typed on a row go to the search.
 */
export function onChooserKey(event: KeyboardEvent<HTMLElement>, search: HTMLInputElement | null): void {
  const { key, target, currentTarget: box } = event;
  if (!(target instanceof HTMLElement) || event.ctrlKey || event.metaKey || event.altKey) return;
  if (!target.closest(OWN)) return;
  const stops = [...box.querySelectorAll<HTMLElement>(`${ROW}, .cycle-group-head`)];
  const inRow = target.closest<HTMLElement>(".cycle-row");
  if (key === "ArrowDown" || key === "ArrowUp") {
    const from = inRow?.querySelector<HTMLElement>(ROW) ?? target;
    const next = nearest(
      from.getBoundingClientRect(),
      stops.filter((each) => each !== from),
      key === "ArrowDown",
    );
    if (next || key === "ArrowUp") {
      event.preventDefault();
      (next ?? search)?.focus();
    }
    return;
  }
  if (!inRow) return;
  if (key === "ArrowRight" || key === "ArrowLeft") {
    const buttons = [...box.querySelectorAll<HTMLElement>(".cycle-row button")];
    const next = buttons[buttons.indexOf(target) + (key === "ArrowRight" ? 1 : -1)];
    if (!next) return;
    event.preventDefault();
    next.focus();
  } else if (isText(key) && search) search.focus();
}
