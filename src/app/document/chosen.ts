import { create } from "zustand";

/**
 * Which finding is looked at, in the list and in the picture alike; `count` goes up each time it is asked for anew, and
 * `shown` is the last time that a picture went there.
 */
export const useChosen = create<{ readonly id: string | null; readonly count: number; readonly shown: number }>(() => ({
  id: null,
  count: 0,
  shown: 0,
}));

/** Shows a finding in the picture, or nothing. */
export const chooseFinding = (id: string | null): void =>
  useChosen.setState((c) => (id === null && c.id === null ? c : { ...c, id, count: c.count + 1 }));
