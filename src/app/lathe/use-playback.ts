import { useEffect, useSyncExternalStore } from "react";
import type { PlaybackStore } from "./playback-store.ts";

/** One plain value of the playback; the component renders again only when that value changes. */
export const usePlayback = <T extends string | number | boolean | null>(store: PlaybackStore, pick: (store: PlaybackStore) => T): T =>
  useSyncExternalStore(store.subscribe, () => pick(store));

/** Runs at once and after each change, without rendering: for what changes with every picture. */
export function useEachPicture(store: PlaybackStore, paint: () => void): void {
  useEffect(() => {
    paint();
    return store.subscribe(paint);
  }, [store, paint]);
}
