import { create } from "zustand";

/** The pane of the view that help pictures go to, where the screen has one; null where they stand among the prompts. */
export const useHelpDock = create<{
  readonly dock: HTMLElement | null;
  /** A help picture stands in it. */
  readonly filled: boolean;
}>(() => ({ dock: null, filled: false }));

/** Ref of the pane. */
export const holdHelpDock = (dock: HTMLElement | null): void => useHelpDock.setState({ dock });

/** A help picture stands in the pane from now on. Gives what says that it does not any more. */
export function fillHelpDock(): () => void {
  useHelpDock.setState({ filled: true });
  return () => useHelpDock.setState({ filled: false });
}
