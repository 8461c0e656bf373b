import { create } from "zustand";
import type { MadeTask } from "../../../course/made/made-task.ts";

/** The forms that were filled in since the page was opened, by the program that they are of: a form that is closed loses nothing. */
const useForms = create<{ readonly forms: Readonly<Record<string, MadeTask>> }>(() => ({ forms: {} }));

export const formOfText = (text: string): MadeTask | undefined => useForms.getState().forms[text];
export const keepForm = (text: string, form: MadeTask): void => useForms.setState(({ forms }) => ({ forms: { ...forms, [text]: form } }));
