import { useEffect, useEffectEvent, useRef, useState } from "react";
import type { StoreApi } from "zustand";

/** Brings a component to the newest state. */
const followers = new Set<() => void>();

/**
 * Renders at once whatever is still rendered by and by. Called where all that is rendered must be of now, inside of
 * `flushSync`.
 */
export function catchUp(): void {
  for (const bring of followers) bring();
}

/**
 * What a component shows of a store, as its own state: what a transition tells of the store is rendered by and by, and
 * all who follow it change together. Zustand's own hook renders every change in one piece, however long that takes on a
 * slow device.
 */
export function useFollowed<S, T>(store: StoreApi<S>, select: (state: S) => T): T {
  const [seen, see] = useState(() => ({ state: store.getState() }));
  /**
   * What was rendered last, or is about to be. A state that looks the same to this component takes its place in
   * silence.
   */
  const last = useRef(seen);
  const look = useEffectEvent(() => {
    const state = store.getState();
    if (Object.is(select(last.current.state), select(state))) last.current.state = state;
    else see((last.current = { state }));
  });
  const bring = useEffectEvent(() => see(last.current));
  useEffect(() => {
    look();
    const stop = store.subscribe(() => look()),
      whenAsked = () => bring();
    followers.add(whenAsked);
    return () => {
      stop();
      followers.delete(whenAsked);
    };
  }, [store]);
  return select(seen.state);
}
