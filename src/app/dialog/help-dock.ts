import { create } from "zustand";

/** The pane of the view that help pictures go to, where the screen has one; null where they stand among the prompts. */
export const useHelpDock = create<{ readonly dock: HTMLElement | null }>(() => ({ dock: null }));

/** Ref of the pane. */
export const holdHelpDock = (dock: HTMLElement | null): void => useHelpDock.setState({ dock });
