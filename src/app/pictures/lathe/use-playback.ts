import { useEffect, useMemo, useSyncExternalStore } from "react";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** One plain value of the playback; the component renders again only when that value changes. */
export const usePlayback = <T extends string | number | boolean | null>(
  store: PlaybackStore,
  pick: (store: PlaybackStore) => T,
): T => useSyncExternalStore(store.subscribe, () => pick(store));

/** The same for lists: during playback they render no faster than they can be read. */
export const useReadPlayback = <T extends string | number | boolean | null>(
  store: PlaybackStore,
  pick: (store: PlaybackStore) => T,
): T => useSyncExternalStore(store.subscribeReader, () => pick(store));

/** A text about the moment while it rests; empty during playback. */
export function useRestingText(store: PlaybackStore, text: () => string): string {
  const resting = usePlayback(store, (s) => (s.get().playing ? -1 : s.get().position.step));
  return useMemo(() => (resting >= 0 ? text() : ""), [resting, text]);
}

/** Runs at once, and then as often as numbers can be read. */
export function useEachReading(store: PlaybackStore, write: () => void): void {
  useEffect(() => {
    write();
    return store.subscribeReader(write);
  }, [store, write]);
}
