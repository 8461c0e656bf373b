import { create } from "zustand";

/** The parts of the page that take turns where there is little room. */
export type JobSection = "prompts" | "setup" | "contour" | "findings" | "program";
/** Those of a whole program: its text, the dialog of one block, the list of its parts. */
export type ProgramSection = "text" | "block" | "structure" | "findings";
export type WorkSection = JobSection | ProgramSection;

/** Where the operator is: not part of the work, so undo does not touch it. */
export interface WorkPlace {
  readonly section: WorkSection;
  /** Q number of the open prompt; null when the dialog is at its end. */
  readonly prompt: string | null;
  /** Text of the open prompt as it was when it opened, for Escape. */
  readonly before: string;
  /** Counts up each time the open field should take the keyboard. */
  readonly focus: number;
  /** Field of the set-up or contour that should take the keyboard, with its own count. */
  readonly field: string | null;
}

export const usePlace = create<WorkPlace>(() => ({ section: "prompts", prompt: null, before: "", focus: 0, field: null }));

/** Marks a place that keeps the keyboard while prompts open beside it: the program text, the list of its parts. */
export const KEEPS_KEYBOARD = "data-keeps-keyboard";

/** False while the operator types elsewhere: a field that opens must not take the keyboard away. */
export const mayTakeKeyboard = (): boolean => !document.activeElement?.closest(`[${KEEPS_KEYBOARD}]`);

/** Opens a prompt with the text that stands in it now. */
export const openPrompt = (prompt: string | null, before: string): void =>
  usePlace.setState((p) => ({ section: "prompts", prompt, before, focus: p.focus + 1, field: null }));

/** Opens a prompt beside what is worked with: a field takes the keyboard only where nothing else keeps it. */
export const showPrompt = (prompt: string, before: string): void => usePlace.setState({ section: "prompts", prompt, before, field: null });

export const showSection = (section: WorkSection): void => usePlace.setState({ section, field: null });

/** Shows a section and puts the keyboard into one of its fields. */
export const goToField = (section: WorkSection, field: string): void => usePlace.setState((p) => ({ section, field, focus: p.focus + 1 }));
