import { useEffectEvent, useImperativeHandle, useLayoutEffect, useRef, type RefObject } from "react";
import type { ValueField } from "../dialog/ValueInput.tsx";
import { useNumberEntry } from "../dialog/use-number-entry.ts";
import { inScreenWriting } from "../dialog/write-value.ts";
import { useSettings } from "../settings/settings.ts";

/** The large value of the open prompt. Every keystroke reaches the block. */
export function WordInput({ text, name, describedBy, invalid, ownKeypad, focus, field, onText }: {
  readonly text: string;
  readonly name: string;
  readonly describedBy: string;
  readonly invalid: boolean;
  /** The page's own keypad is there: the system's must not cover the picture. */
  readonly ownKeypad: boolean;
  /** Takes the keyboard each time this changes from one number to another; not at first. */
  readonly focus: number;
  readonly field: RefObject<ValueField | null>;
  readonly onText: (text: string) => void;
}) {
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const { read, write, onKeyDown, onTyped } = useNumberEntry(input, text, onText);
  const opened = useEffectEvent(() => {
    onTyped();
    if (focus === 0) return;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  });
  useLayoutEffect(() => opened(), [focus, name]);
  useImperativeHandle(field, () => ({ read, write, focus: () => input.current?.focus({ preventScroll: true }) }));
  return (
    <input
      ref={input} className="value number" type="text" inputMode={ownKeypad ? "none" : "text"} enterKeyHint="next" autoComplete="off"
      autoCapitalize="characters" spellCheck={false} maxLength={200} aria-label={name} aria-describedby={describedBy} aria-invalid={invalid}
      value={inScreenWriting(language, text)}
      onChange={(event) => {
        onTyped();
        onText(event.currentTarget.value);
      }}
      onKeyDown={onKeyDown}
    />
  );
}
