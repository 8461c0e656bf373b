import { useImperativeHandle, useLayoutEffect, useRef, type KeyboardEvent, type RefObject } from "react";
import { useSettings } from "../settings/settings.ts";
import { setPrompt } from "../edits.ts";
import { usePlace } from "../place.ts";
import { commit } from "./prompts.ts";
import { insert, minus, type Entry } from "./number-entry.ts";
import { inScreenWriting } from "./write-value.ts";

interface Props {
  readonly q: string;
  readonly text: string;
  readonly name: string;
  readonly describedBy: string;
  readonly invalid: boolean;
  /** The page's own keypad is there: the system's must not cover the picture. */
  readonly ownKeypad: boolean;
  readonly field: RefObject<ValueField | null>;
}

/** What the keypad does to the open field. */
export interface ValueField {
  readonly read: () => Entry;
  readonly write: (entry: Entry) => void;
  readonly focus: () => void;
}

/** The large value of the open prompt. Every keystroke reaches the work; leaving the field commits it. */
export function ValueInput({ q, text, name, describedBy, invalid, ownKeypad, field }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const negative = useRef(false);
  const pending = useRef<Entry | null>(null);
  const focus = usePlace((p) => p.focus);
  const language = useSettings((s) => s.language);

  const read = (): Entry => {
    const element = input.current;
    const value = element?.value ?? "";
    return { text: value, from: element?.selectionStart ?? value.length, to: element?.selectionEnd ?? value.length, negative: negative.current };
  };
  const write = (entry: Entry) => {
    negative.current = entry.negative;
    pending.current = entry;
    setPrompt(q, entry.text);
  };

  useLayoutEffect(() => {
    const entry = pending.current;
    pending.current = null;
    if (entry) input.current?.setSelectionRange(entry.from, entry.to);
  }, [text]);

  useLayoutEffect(() => {
    negative.current = false;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  }, [q, focus]);

  useImperativeHandle(field, () => ({ read, write, focus: () => input.current?.focus({ preventScroll: true }) }));

  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const entry = read();
    const next = event.key === "-" || event.key === "−" ? minus(entry)
      : entry.negative && /^[\d.,]$/.test(event.key) ? insert(entry, event.key) : null;
    if (!next) return;
    event.preventDefault();
    write(next);
  };

  return (
    <input
      ref={input}
      className="value number"
      type="text"
      inputMode={ownKeypad ? "none" : "decimal"}
      enterKeyHint="next"
      autoComplete="off"
      autoCapitalize="characters"
      spellCheck={false}
      maxLength={200}
      aria-label={name}
      aria-describedby={describedBy}
      aria-invalid={invalid}
      value={inScreenWriting(language, text)}
      onChange={(event) => {
        negative.current = false;
        setPrompt(q, event.currentTarget.value);
      }}
      onKeyDown={onKeyDown}
      onBlur={commit}
    />
  );
}
