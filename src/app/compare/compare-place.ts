import { create } from "zustand";

/** Shows a block of the open work: by its index in one of its files (null: the program that runs), and by its number. */
export type ShowBlock = (file: string | null, index: number, number: number) => void;

/** The way to a block of the open work while that is compared with another; null while it is not. Undo does not touch it. */
export const useComparing = create<{ readonly showBlock: ShowBlock | null }>(() => ({ showBlock: null }));

export const showComparison = (showBlock: ShowBlock): void => useComparing.setState({ showBlock });
export const hideComparison = (): void => useComparing.setState({ showBlock: null });
