import { create } from "zustand";
import { useEditor } from "./store.ts";

interface Inserting {
  /** Index of the operation to insert after; null inserts before all others. */
  readonly behind: number | null;
  /** The work to insert into; null while none is being inserted. */
  readonly work: string | null;
}

const useAsked = create<Inserting>(() => ({ behind: null, work: null }));

/** The pending insertion into the open work, or null. */
export function useInserting(): Inserting | null {
  const asked = useAsked();
  const work = useEditor((s) => s.work);
  return asked.work !== null && asked.work === work ? asked : null;
}

/** Starts inserting an operation after another one of the open work; null inserts before all others. */
export const askForOperation = (behind: number | null): void =>
  useAsked.setState({ behind, work: useEditor.getState().work });
export const stopInserting = (): void => useAsked.setState({ work: null });
