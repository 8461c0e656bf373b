import { create } from "zustand";

/** Whether an operation is being put in, and behind which: its place in the list, null for the first of all. */
export const useInserting = create<{ readonly behind: number | null; readonly asked: boolean }>(() => ({ behind: null, asked: false }));

/** Asks for an operation behind another one; null puts it before all others. */
export const askForOperation = (behind: number | null): void => useInserting.setState({ behind, asked: true });
export const stopInserting = (): void => useInserting.setState({ asked: false });
