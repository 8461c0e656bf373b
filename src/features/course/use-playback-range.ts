import { useEffect, useMemo, useRef } from "react";
import type { StepRange } from "../../course/playback-range.ts";
import type { Run } from "../../program/state/run-types.ts";
import { secondsAt, trackOf } from "../../view/playback.ts";
import type { PlaybackStore } from "../../app/calculation/playback-store.ts";

/** Playback duration of a range, in seconds of the clock: a base and a little for each move, within bounds. */
const LASTS = { base: 6, move: 0.12, most: 28 } as const;

/** Controls of the playback within the range of a page. */
export interface PlaybackRange {
  readonly toggle: () => void;
  readonly restart: () => void;
  /** Seeks, in machine seconds from the start of the range. */
  readonly seek: (seconds: number) => void;
  /** The current machine seconds, and those at the end of the range. */
  readonly now: () => number;
  readonly length: number;
}

/**
 * The playback of a run, limited to a range. A new page shows its start or its end, or plays; while a slider moves, the
 * moment stays the same, or at the end if it was at the end.
 */
export function usePlaybackRange(
  store: PlaybackStore,
  run: Run,
  { first, last }: StepRange,
  opens: { readonly page: string; readonly at: "start" | "end" | "play" },
): PlaybackRange {
  const track = useMemo(() => trackOf(run.steps), [run]);
  const from = secondsAt(track, { step: first, fraction: 0 });
  const length = secondsAt(track, { step: last + 1, fraction: 0 }) - from;
  const shown = useRef<{ readonly page: string; readonly last: number } | null>(null);
  const { page, at } = opens;

  useEffect(() => {
    if (track.ends.length === 0) return;
    const before = shown.current;
    shown.current = { page, last };
    const seek = (step: number) => store.dispatch({ do: "seek", position: { step, fraction: 0 } });
    const stoodAtEnd = before !== null && store.get().position.step > before.last;
    store.dispatch({ do: "load", track });
    if (length > 0)
      store.dispatch({ do: "rate", rate: length / Math.min(LASTS.most, LASTS.base + LASTS.move * (last - first)) });
    if (before?.page === page) {
      if (stoodAtEnd) seek(last + 1);
      return;
    }
    store.dispatch({ do: "pause" });
    seek(at === "end" ? last + 1 : first);
    if (at === "play") store.dispatch({ do: "play" });
  }, [store, track, first, last, length, page, at]);

  useEffect(() => {
    // Stops at the end of the range.
    const stop = store.subscribe(() => {
      const { playing, position } = store.get();
      if (!playing || position.step <= last) return;
      store.dispatch({ do: "pause" });
      store.dispatch({ do: "seek", position: { step: last + 1, fraction: 0 } });
    });
    return () => void stop();
  }, [store, last]);

  useEffect(() => () => store.dispatch({ do: "pause" }), [store]);

  const toStart = () => store.dispatch({ do: "seek", position: { step: first, fraction: 0 } });
  return {
    toggle() {
      if (!store.get().playing && store.get().position.step > last) toStart();
      store.dispatch({ do: "toggle" });
    },
    restart() {
      store.dispatch({ do: "pause" });
      toStart();
    },
    seek: (seconds) => store.dispatch({ do: "seekSeconds", seconds: from + seconds }),
    now: () => Math.min(length, Math.max(0, secondsAt(store.get().track, store.get().position) - from)),
    length,
  };
}
