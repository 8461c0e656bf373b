import { useEffectEvent, useImperativeHandle, useLayoutEffect, useRef, useState, type RefObject } from "react";
import { useSettings } from "../settings/settings.ts";
import { useTimesTold, whileTyping } from "../typing.ts";
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

/** What was typed: the work says it a moment later. */
interface Typed {
  readonly id: string;
  /** How often it had been told what was typed. */
  readonly told: number;
  readonly text: string;
}

/** The large value of the open prompt. Every keystroke reaches the work; leaving the field settles it. */
export function ValueInput({ session, prompt: { id, name, suggestion }, describedBy, invalid, ownKeypad, input: field }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const text = session.draft[id] ?? "";
  const [newest, follow] = useState<Typed | null>(null);
  const told = useTimesTold(), isNewest = newest?.id === id && newest.told === told;
  const value = inScreenWriting(language, isNewest ? newest.text : text);
  const type = (next: string) => {
    follow({ id, told, text: next });
    whileTyping(() => session.set(id, next));
  };
  const { read, write, onKeyDown, onTyped } = useNumberEntry(input, value, type);
  const opened = useEffectEvent(() => {
    onTyped();
    if (!session.mayFocus()) return;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  });

  useLayoutEffect(() => opened(), [id, session.opened.focus]);
  useImperativeHandle(field, () => ({ read, write, focus: () => input.current?.focus({ preventScroll: true }) }));

  return (
    <input ref={input} className="value number" type="text" inputMode={ownKeypad ? "none" : session.keypad === "sums" ? "decimal" : "text"}
      enterKeyHint="next" autoComplete="off" autoCapitalize="characters" spellCheck={false} maxLength={200} aria-label={name}
      aria-describedby={describedBy} aria-invalid={invalid} {...(suggestion && { placeholder: inScreenWriting(language, suggestion.text) })}
      value={value} onChange={(event) => {
      onTyped();
      type(event.currentTarget.value);
    }} onKeyDown={onKeyDown} onBlur={() => commandsOf(session).leave()} />
  );
}
