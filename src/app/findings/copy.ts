import { create } from "zustand";
import type { ShownVerdict } from "./verdict.ts";

/** How the last copying went; null before it and once its message is gone. */
export interface Copying {
  readonly state: "copied" | "refused" | null;
  /** The text that was asked for. */
  readonly text: string;
  /** The verdict that went with it; null for what is no program. */
  readonly verdict: ShownVerdict | null;
}

export const useCopying = create<Copying>(() => ({ state: null, text: "", verdict: null }));

/** How long "Copied" stays, ms. */
const SHOWN = 8000;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Puts text on the clipboard; where the browser refuses, the text is shown to be copied by hand. */
export async function copyText(text: string, verdict: ShownVerdict | null = null): Promise<void> {
  clearTimeout(timer);
  try {
    await navigator.clipboard.writeText(text);
    useCopying.setState({ state: "copied", text, verdict });
    timer = setTimeout(() => useCopying.setState({ state: null }), SHOWN);
  } catch {
    useCopying.setState({ state: "refused", text, verdict });
  }
}

export const closeCopying = (): void => useCopying.setState({ state: null });
