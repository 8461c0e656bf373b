import { useSyncExternalStore } from "react";

/** Where fingers work: a coarse pointer, or a screen without room for the three columns. */
const query = "(pointer: coarse), (max-width: 1279px)";

const matches = () => typeof matchMedia === "function" && matchMedia(query).matches;

function subscribe(listener: () => void): () => void {
  if (typeof matchMedia !== "function") return () => undefined;
  const media = matchMedia(query);
  media.addEventListener("change", listener);
  return () => media.removeEventListener("change", listener);
}

/** True where the page shows its own keypad and large targets. The same condition stands in `tokens.css`. */
export const useFingers = (): boolean => useSyncExternalStore(subscribe, matches, () => false);

/** True where a media query holds; follows it. */
export function useMedia(condition: string): boolean {
  return useSyncExternalStore(
    (listener) => {
      if (typeof matchMedia !== "function") return () => undefined;
      const media = matchMedia(condition);
      media.addEventListener("change", listener);
      return () => media.removeEventListener("change", listener);
    },
    () => typeof matchMedia === "function" && matchMedia(condition).matches,
    () => false,
  );
}
