import { useSyncExternalStore } from "react";
import { MEDIA } from "./media.ts";
import { useSettings } from "./settings/settings.ts";

interface Watched {
  readonly matches: () => boolean;
  readonly subscribe: (listener: () => void) => () => void;
}

const never: Watched = { matches: () => false, subscribe: () => () => undefined };
const watched = new Map<string, Watched>();

/** One cached media query per condition: asking the browser again costs time at every key. */
function watch(condition: string): Watched {
  if (typeof matchMedia !== "function") return never;
  const known = watched.get(condition);
  if (known) return known;
  const media = matchMedia(condition),
    print = matchMedia("print");
  let last = media.matches;
  const made: Watched = {
    // Printing keeps the layout of the screen.
    matches: () => {
      if (!print.matches) last = media.matches;
      return last;
    },
    subscribe(listener) {
      media.addEventListener("change", listener);
      return () => media.removeEventListener("change", listener);
    },
  };
  watched.set(condition, made);
  return made;
}

/** Whether one of the page's media conditions holds; follows changes. */
export function useMedia(name: keyof typeof MEDIA): boolean {
  const { matches, subscribe } = watch(MEDIA[name]);
  return useSyncExternalStore(subscribe, matches, () => false);
}

/** Whether the page shows its own keypad and large targets. */
export const useFingers = (): boolean => useMedia("fingers");

/** Whether one of the page's media conditions holds now. */
export const holds = (name: keyof typeof MEDIA): boolean => watch(MEDIA[name]).matches();

/** On screens of usual size large type leaves no room for the third column. */
const hasColumns = (wide: boolean, broad: boolean, presentation: boolean): boolean => wide && (broad || !presentation);

/** Whether the program is beside the view, and not one of the tabs. */
export const useThirdColumn = (): boolean =>
  hasColumns(
    useMedia("wide"),
    useMedia("broad"),
    useSettings((s) => s.presentation),
  );

/** The same outside of a component. */
export const thirdColumn = (): boolean =>
  hasColumns(holds("wide"), holds("broad"), useSettings.getState().presentation);
