import { useSyncExternalStore } from "react";
import { MEDIA } from "./media.ts";
import { useSettings } from "./settings/settings.ts";

interface Watched {
  readonly matches: () => boolean;
  readonly subscribe: (listener: () => void) => () => void;
}

const never: Watched = { matches: () => false, subscribe: () => () => undefined };
const watched = new Map<string, Watched>();

/** One list per condition for the whole page: asking the browser anew costs time at every keystroke. */
function watch(condition: string): Watched {
  if (typeof matchMedia !== "function") return never;
  const known = watched.get(condition);
  if (known) return known;
  const media = matchMedia(condition),
    print = matchMedia("print");
  let last = media.matches;
  const made: Watched = {
    // A sheet of paper is no screen: what is printed stays as it was arranged.
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

/** True where one of the page's conditions holds; follows it. */
export function useMedia(name: keyof typeof MEDIA): boolean {
  const { matches, subscribe } = watch(MEDIA[name]);
  return useSyncExternalStore(subscribe, matches, () => false);
}

/** True where the page shows its own keypad and large targets. */
export const useFingers = (): boolean => useMedia("fingers");

/** True where one of the page's conditions holds now. */
export const holds = (name: keyof typeof MEDIA): boolean => watch(MEDIA[name]).matches();

/** Large type takes the room of the third column on screens of usual size. */
const hasColumns = (wide: boolean, broad: boolean, presentation: boolean): boolean => wide && (broad || !presentation);

/** True where the program stands beside the view, and not among the panels that take turns. */
export const useThirdColumn = (): boolean =>
  hasColumns(
    useMedia("wide"),
    useMedia("broad"),
    useSettings((s) => s.presentation),
  );

/** The same, as it is now. */
export const thirdColumn = (): boolean =>
  hasColumns(holds("wide"), holds("broad"), useSettings.getState().presentation);
