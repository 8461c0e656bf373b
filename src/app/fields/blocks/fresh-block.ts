import { create } from "zustand";

/** The APPR or DEP block that was just inserted; its dialog starts with the choice of the form. */
const useFresh = create<{ readonly index: number | null }>(() => ({ index: null }));

export const markFresh = (index: number | null): void => useFresh.setState({ index });
export const isFresh = (index: number): boolean => useFresh.getState().index === index;
