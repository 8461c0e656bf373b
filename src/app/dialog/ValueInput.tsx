import { useEffectEvent, useImperativeHandle, useLayoutEffect, useRef, type RefObject } from "react";
import { useSettings } from "../settings/settings.ts";
import { setPrompt } from "../edits.ts";
import { mayTakeKeyboard, usePlace } from "../place.ts";
import { commit } from "./prompts.ts";
import type { Entry } from "./number-entry.ts";
import { useNumberEntry } from "./use-number-entry.ts";
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
  const focus = usePlace((p) => p.focus);
  const language = useSettings((s) => s.language);
  const { read, write, onKeyDown, onTyped } = useNumberEntry(input, text, (typed) => setPrompt(q, typed));
  const opened = useEffectEvent(() => {
    onTyped();
    if (!mayTakeKeyboard()) return;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  });

  useLayoutEffect(() => opened(), [q, focus]);
  useImperativeHandle(field, () => ({ read, write, focus: () => input.current?.focus({ preventScroll: true }) }));

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
        onTyped();
        setPrompt(q, event.currentTarget.value);
      }}
      onKeyDown={onKeyDown}
      onBlur={commit}
    />
  );
}
