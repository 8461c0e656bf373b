import { inScreenWriting } from "../../../i18n/number.ts";
import { useLayoutEffect, useRef, type ComponentProps, type KeyboardEvent } from "react";
import { sumOf } from "../../../program/values/field.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { NumberLetters } from "../keypad/field-typing.ts";
import { insert, minuendOf, minus, subtracted, type EntryState } from "./number-entry.ts";

export interface NumberInputProps extends Omit<
  ComponentProps<"input">,
  "type" | "value" | "onChange" | "onBlur" | "onFocus"
> {
  readonly text: string;
  /** Called with the text at each keystroke, and with the value of a sum on blur. */
  readonly onText: (text: string) => void;
  /** Called on blur, after a sum was evaluated. */
  readonly onLeave?: () => void;
  /**
   * "typed" is taken literally: no sign key, no sums, no decimal sign of the screen. So is "text", which does not look
   * like a number.
   */
  readonly kind?: "number" | "typed" | "text";
  /** The minus key changes the sign, wherever the caret is. */
  readonly signed?: boolean;
  readonly sums?: boolean;
  /** Touch keypad; by default the app's own for a number, none for text. */
  readonly keypad?: NumberLetters | "none";
  /** Selects all on focus. */
  readonly selects?: boolean;
  /** Key of the shown value, if the same field shows several in turn. */
  readonly of?: string;
}

/**
 * The input for a number, an expression or a word, used everywhere on the page. Attributes of an input element are
 * passed on to it.
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

/** Minus key of a number field; `end` resets it after other input. */
function useSignKey(of: string | undefined, text: string, onText: (text: string) => void) {
  const negative = useRef(false);
  /** Text before the last key, if that was a minus that changed its sign. */
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
      // A second minus takes the first one back.
      minuend.current = isMinus && from === null ? minuendOf(entry) : null;
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
