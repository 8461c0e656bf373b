import { useSyncExternalStore } from "react";

/** Where fingers work: a coarse pointer, or a screen without room for the three columns. */
const FINGERS = "(pointer: coarse), (max-width: 1279px)";

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
  const media = matchMedia(condition);
  const made: Watched = {
    matches: () => media.matches,
    subscribe(listener) {
      media.addEventListener("change", listener);
      return () => media.removeEventListener("change", listener);
    },
  };
  watched.set(condition, made);
  return made;
}

/** True where a media query holds; follows it. */
export function useMedia(condition: string): boolean {
  const { matches, subscribe } = watch(condition);
  return useSyncExternalStore(subscribe, matches, () => false);
}

/** True where the page shows its own keypad and large targets. The same condition stands in `tokens.css`. */
export const useFingers = (): boolean => useMedia(FINGERS);
