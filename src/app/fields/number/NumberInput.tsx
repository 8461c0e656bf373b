import { useLayoutEffect, useRef, type ComponentProps, type KeyboardEvent } from "react";
import { sumOf } from "../../../program/values/field.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { inScreenWriting } from "../dialog/write-value.ts";
import type { NumberLetters } from "../keypad/field-typing.ts";
import { insert, minuendOf, minus, subtracted, type EntryState } from "./number-entry.ts";

export interface NumberInputProps extends Omit<
  ComponentProps<"input">,
  "type" | "value" | "onChange" | "onBlur" | "onFocus"
> {
  readonly text: string;
  /** Takes the text at each keystroke, and the value of a sum when the field is left. */
  readonly onText: (text: string) => void;
  /** When the field is left, after a sum was worked out. */
  readonly onLeave?: () => void;
  /**
   * "typed" is taken literally: no sign key, no sums, no decimal sign of the screen. So is "text", which does not look
   * like a number.
   */
  readonly kind?: "number" | "typed" | "text";
  /** The minus key changes the sign, wherever the caret is. */
  readonly signed?: boolean;
  readonly sums?: boolean;
  /** Which keypad comes up under fingers; by default one of its own for a number, none for text. */
  readonly keypad?: NumberLetters | "none";
  /** All is selected when the field takes the keyboard. */
  readonly selects?: boolean;
  /** Which value it shows, where the same field goes on to show another one. */
  readonly of?: string;
}

/**
 * The field for a number, an expression or a word: every one of the page. Attributes of an input element are passed on
 * to it.
 */
export function NumberInput({
  text,
  onText,
  onLeave,
  kind = "number",
  signed = true,
  sums = true,
  keypad,
  selects,
  of,
  ...rest
}: NumberInputProps) {
  const language = useSettings((s) => s.language);
  const sign = useSignKey(of, text, onText);
  const isNumber = kind === "number";
  const letters = keypad ?? (isNumber ? "words" : "none");
  return (
    <input
      className={kind === "text" ? "input" : "input number"}
      type="text"
      inputMode={isNumber ? "decimal" : "text"}
      autoComplete="off"
      spellCheck={false}
      maxLength={isNumber ? 200 : 500}
      {...(letters !== "none" && { "data-number": letters })}
      {...rest}
      value={isNumber ? inScreenWriting(language, text) : text}
      onChange={(event) => {
        sign.end();
        onText(event.currentTarget.value);
      }}
      onBlur={() => {
        const sum = isNumber && sums ? sumOf(text) : null;
        if (sum !== null) onText(sum);
        onLeave?.();
      }}
      onFocus={(event) => {
        if (selects) event.currentTarget.select();
      }}
      onKeyDown={(event) => {
        rest.onKeyDown?.(event);
        if (isNumber && signed && !event.defaultPrevented) sign.onKeyDown(event);
      }}
    />
  );
}

/** The minus key of a number field; `end`: what it began is over, since something else was typed. */
function useSignKey(of: string | undefined, text: string, onText: (text: string) => void) {
  const negative = useRef(false);
  /** What stood in the field when the last key was a minus that changed its sign. */
  const minuend = useRef<string | null>(null);
  const pending = useRef<(() => void) | null>(null);
  useLayoutEffect(() => {
    pending.current?.();
    pending.current = null;
  }, [text]);
  useLayoutEffect(() => {
    negative.current = false;
  }, [of]);
  return {
    end() {
      negative.current = false;
    },
    onKeyDown(event: KeyboardEvent<HTMLInputElement>) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const input = event.currentTarget,
        { value } = input;
      const entry: EntryState = {
        text: value,
        from: input.selectionStart ?? value.length,
        to: input.selectionEnd ?? value.length,
        negative: negative.current,
      };
      const isMinus = event.key === "-" || event.key === "−";
      const isDigit = /^[\d.,]$/.test(event.key);
      const from = minuend.current;
      minuend.current = isMinus ? minuendOf(entry) : null;
      const sum = isDigit && from !== null ? subtracted(entry, from, event.key) : null;
      const next = sum ?? (isMinus ? minus(entry) : entry.negative && isDigit ? insert(entry, event.key) : null);
      if (!next) return;
      event.preventDefault();
      negative.current = next.negative;
      pending.current = () => input.setSelectionRange(next.from, next.to);
      onText(next.text);
    },
  };
}
