import { create } from "zustand";
import type { ShownVerdict } from "./verdict.ts";
import { restartable } from "../base/once.ts";

/** Result of the last copy; null before it and once its message is gone. */
export interface Copying {
  readonly state: "copied" | "refused" | null;
  /** The copied text. */
  readonly text: string;
  /** The verdict shown with it; null if the text is no program. */
  readonly verdict: ShownVerdict | null;
}

export const useCopying = create<Copying>(() => ({ state: null, text: "", verdict: null }));

/** How long "Copied" stays, ms. */
const SHOWN = 8000;
const shown = restartable();

/** Puts text on the clipboard; where the browser refuses, the text is shown to be copied by hand. */
export async function copyText(text: string, verdict: ShownVerdict | null = null): Promise<void> {
  shown.stop();
  try {
    await navigator.clipboard.writeText(text);
    useCopying.setState({ state: "copied", text, verdict });
    shown.start(() => useCopying.setState({ state: null }), SHOWN);
  } catch {
    useCopying.setState({ state: "refused", text, verdict });
  }
}

export const closeCopying = (): void => useCopying.setState({ state: null });
