import { useLayoutEffect, useRef, type KeyboardEvent, type RefObject } from "react";
import { insert, minuendOf, minus, subtracted, type EntryState } from "./number-entry.ts";

/** The typing of numbers in an input element: the minus key changes the sign, wherever the caret is. */
export interface NumberEntry {
  readonly read: () => EntryState;
  readonly write: (entry: EntryState) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
  /** The element's own change: what was begun by the minus key is over. */
  readonly onTyped: () => void;
}

/** `text` is what the element shows; `onText` takes what it shall show. */
export function useNumberEntry(input: RefObject<HTMLInputElement | null>, text: string, onText: (text: string) => void): NumberEntry {
  const negative = useRef(false);
  /** What stood in the field when the last key was a minus that changed its sign. */
  const minuend = useRef<string | null>(null);
  const pending = useRef<EntryState | null>(null);

  useLayoutEffect(() => {
    const entry = pending.current;
    pending.current = null;
    if (entry) input.current?.setSelectionRange(entry.from, entry.to);
  }, [input, text]);

  const read = (): EntryState => {
    const element = input.current;
    const value = element?.value ?? "";
    return {
      text: value,
      from: element?.selectionStart ?? value.length,
      to: element?.selectionEnd ?? value.length,
      negative: negative.current,
    };
  };
  const write = (entry: EntryState) => {
    negative.current = entry.negative;
    pending.current = entry;
    onText(entry.text);
  };
  return {
    read,
    write,
    onKeyDown(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const entry = read();
      const isMinus = event.key === "-" || event.key === "−";
      const isDigit = /^[\d.,]$/.test(event.key);
      const from = minuend.current;
      minuend.current = isMinus ? minuendOf(entry) : null;
      const sum = isDigit && from !== null ? subtracted(entry, from, event.key) : null;
      const next = sum ?? (isMinus ? minus(entry) : entry.negative && isDigit ? insert(entry, event.key) : null);
      if (!next) return;
      event.preventDefault();
      write(next);
    },
    onTyped() {
      negative.current = false;
    },
  };
}
