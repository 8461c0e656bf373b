import { create } from "zustand";

/**
 * The selected finding, in the list and in the picture; `count` goes up with each selection, and `shown` is the last
 * count that a picture went to.
 */
export const useChosenFinding = create<{ readonly id: string | null; readonly count: number; readonly shown: number }>(
  () => ({
    id: null,
    count: 0,
    shown: 0,
  }),
);

/** Selects a finding, or none. */
export const chooseFinding = (id: string | null): void =>
  useChosenFinding.setState((c) => (id === null && c.id === null ? c : { ...c, id, count: c.count + 1 }));
