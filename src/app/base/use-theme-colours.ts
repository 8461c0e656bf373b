import { useSyncExternalStore } from "react";
import { changes } from "./changes.ts";

const CAN_WATCH = typeof MutationObserver !== "undefined";
const themes = changes((changed) => {
  if (CAN_WATCH)
    new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-theme", "data-size"] });
});

/** Changes with the theme of the page: whoever paints with its colours has to read them again. */
export const useTheme = (): number => useSyncExternalStore(themes.subscribe, themes.count, () => 0);

const read = new WeakMap<object, { readonly theme: number; readonly colours: Record<string, string> }>();

/**
 * The current values of custom properties of the page, under the given names. They are read once per theme, since the
 * browser computes the styles of the whole page for it.
 */
export function pageColours<Name extends string>(names: Readonly<Record<Name, string>>): Record<Name, string> {
  const theme = themes.count(),
    known = read.get(names);
  if (CAN_WATCH && known?.theme === theme) return known.colours;
  const style = getComputedStyle(document.documentElement);
  const entries = Object.entries<string>(names).map(([name, property]) => [
    name,
    style.getPropertyValue(property).trim(),
  ]);
  const colours = Object.fromEntries(entries) as Record<Name, string>;
  read.set(names, { theme, colours });
  return colours;
}
