import { create } from "zustand";

/** How the last copying went; null before it and once its message is gone. */
export interface Copying {
  readonly state: "copied" | "refused" | null;
  /** The text that was asked for. */
  readonly text: string;
}

export const useCopying = create<Copying>(() => ({ state: null, text: "" }));

/** How long "Copied" stays, ms. */
const SHOWN = 4000;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Puts text on the clipboard; where the browser refuses, the text is shown to be copied by hand. */
export async function copyText(text: string): Promise<void> {
  clearTimeout(timer);
  try {
    await navigator.clipboard.writeText(text);
    useCopying.setState({ state: "copied", text });
    timer = setTimeout(() => useCopying.setState({ state: null }), SHOWN);
  } catch {
    useCopying.setState({ state: "refused", text });
  }
}

export const closeCopying = (): void => useCopying.setState({ state: null });
