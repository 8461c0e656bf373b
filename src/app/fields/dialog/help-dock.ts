import { create } from "zustand";

/** The pane for help pictures; null if they are shown among the prompts. */
export const useHelpDock = create<{
  readonly dock: HTMLElement | null;
  /** A help picture is in it. */
  readonly filled: boolean;
}>(() => ({ dock: null, filled: false }));

/** Ref of the pane. */
export const holdHelpDock = (dock: HTMLElement | null): void => useHelpDock.setState({ dock });

/** Marks the pane as filled. Returns the function that clears the mark. */
export function fillHelpDock(): () => void {
  useHelpDock.setState({ filled: true });
  return () => useHelpDock.setState({ filled: false });
}
