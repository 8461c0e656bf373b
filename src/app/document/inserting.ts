import { create } from "zustand";
import { useEditor } from "./store.ts";

interface Inserting {
  /** Behind which operation, by its place in the list; null puts it before all others. */
  readonly behind: number | null;
  /** The work that it is asked for; null while nobody asks. */
  readonly work: string | null;
}

const useAsked = create<Inserting>(() => ({ behind: null, work: null }));

/** The operation that is being put into the open work; null while none is. */
export function useInserting(): Inserting | null {
  const asked = useAsked();
  const work = useEditor((s) => s.work);
  return asked.work !== null && asked.work === work ? asked : null;
}

/** Asks for an operation of the open work behind another one; null puts it before all others. */
export const askForOperation = (behind: number | null): void =>
  useAsked.setState({ behind, work: useEditor.getState().work });
export const stopInserting = (): void => useAsked.setState({ work: null });
