import { useSyncExternalStore } from "react";

let count = 0;
const listeners = new Set<() => void>();
let watching = false;

/** Counts each time the page takes on another theme. */
function watch(): void {
  if (watching || typeof MutationObserver === "undefined") return;
  watching = true;
  new MutationObserver(() => {
    count += 1;
    for (const listener of [...listeners]) listener();
  }).observe(document.documentElement, { attributeFilter: ["data-theme", "data-size"] });
}

function subscribe(listener: () => void): () => void {
  watch();
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** Changes when the page takes on another theme: what paints with colours of its own reads them anew then. */
export const useTheme = (): number => useSyncExternalStore(subscribe, () => count, () => 0);

const read = new WeakMap<object, { readonly theme: number; readonly colours: Record<string, string> }>();

/**
 * The values that custom properties of the page have now, by the names they are wanted under. They are read once for a theme: the browser
 * works out the styles of the whole page to tell them.
 */
export function pageColours<Name extends string>(names: Readonly<Record<Name, string>>): Record<Name, string> {
  watch();
  const known = read.get(names);
  if (watching && known?.theme === count) return known.colours;
  const style = getComputedStyle(document.documentElement);
  const entries = Object.entries<string>(names).map(([name, property]) => [name, style.getPropertyValue(property).trim()]);
  const colours = Object.fromEntries(entries) as Record<Name, string>;
  read.set(names, { theme: count, colours });
  return colours;
}
