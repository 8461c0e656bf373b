import { useEffectEvent, useImperativeHandle, useLayoutEffect, useRef, type RefObject } from "react";
import { useSettings } from "../../base/settings/settings.ts";
import { useTyping } from "../../base/typing.ts";
import type { EntryState } from "./number-entry.ts";
import { commandsOf, type Prompt, type PromptSession } from "./session.ts";
import { useNumberEntry } from "./use-number-entry.ts";
import { inScreenWriting } from "./write-value.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly describedBy: string;
  readonly invalid: boolean;
  /** The page's own keypad is there: the system's must not cover the picture. */
  readonly ownKeypad: boolean;
  readonly input: RefObject<ValueField | null>;
}

/** What the keypad does to the open field. */
export interface ValueField {
  readonly read: () => EntryState;
  readonly write: (entry: EntryState) => void;
  readonly focus: () => void;
}

/** The large value of the open prompt. Every keystroke reaches the work; leaving the field settles it. */
export function ValueInput({ session, prompt: { id, name, suggestion }, describedBy, invalid, ownKeypad, input: field }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const [text, type] = useTyping(id, session.draft[id] ?? "", (typed) => session.set(id, typed));
  const { read, write, onKeyDown, onTyped } = useNumberEntry(input, text, type);
  const opened = useEffectEvent(() => {
    onTyped();
    if (!session.mayFocus()) return;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  });

  useLayoutEffect(() => opened(), [id, session.opened.focus]);
  useImperativeHandle(field, () => ({ read, write, focus: () => input.current?.focus({ preventScroll: true }) }));

  // A placeholder that is covered by a value would get its style anew with each digit.
  const placeholder = suggestion && text === "" ? inScreenWriting(language, suggestion.text) : undefined;
  return (
    <div className="value-box">
      <input ref={input} className="value number" type="text"
        inputMode={ownKeypad ? "none" : session.keypad === "sums" ? "decimal" : "text"} enterKeyHint="next" autoComplete="off"
        autoCapitalize="characters" spellCheck={false} maxLength={200} aria-label={name} aria-describedby={describedBy}
        aria-invalid={invalid} placeholder={placeholder} value={inScreenWriting(language, text)} onChange={(event) => {
        onTyped();
        type(event.currentTarget.value);
      }} onKeyDown={onKeyDown} onBlur={() => commandsOf(session).leave()} />
    </div>
  );
}
