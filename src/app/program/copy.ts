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

/** Hands a file to the browser's downloads. */
export function downloadText(text: string, file: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = file;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
