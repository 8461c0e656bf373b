import { inScreenWriting } from "../../../i18n/number.ts";
import { useEffectEvent, useLayoutEffect, type RefObject } from "react";
import { useSettings } from "../../base/settings/settings.ts";
import { useTyping } from "../../base/typing.ts";
import { NumberInput } from "../number/NumberInput.tsx";
import { commandsOf, type Prompt, type PromptSession } from "./session.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly describedBy: string;
  readonly invalid: boolean;
  /** The page shows its own keypad, so the device keyboard stays closed. */
  readonly ownKeypad: boolean;
  readonly input: RefObject<HTMLInputElement | null>;
}

/** The large value of the open prompt. Every keystroke updates the work; leaving the field evaluates sums. */
export function ValueInput({
  session,
  prompt: { id, name, suggestion },
  describedBy,
  invalid,
  ownKeypad,
  input,
}: Props) {
  const language = useSettings((s) => s.language);
  const [text, type] = useTyping(id, session.draft[id] ?? "", (typed) => session.set(id, typed));
  const opened = useEffectEvent(() => {
    if (!session.mayFocus()) return;
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  });
  useLayoutEffect(() => opened(), [id, session.opened.focus]);

  // A placeholder hidden by a value would be restyled with each digit.
  const placeholder = suggestion !== undefined && text === "" ? inScreenWriting(language, suggestion) : undefined;
  return (
    <div className="value-box">
      <NumberInput
        ref={input}
        className="value number"
        of={`${id} ${session.opened.focus}`}
        text={text}
        onText={type}
        sums={false}
        keypad="none"
        inputMode={ownKeypad ? "none" : session.keypad === "sums" ? "decimal" : "text"}
        enterKeyHint="next"
        autoCapitalize="characters"
        aria-label={name}
        aria-describedby={describedBy}
        aria-invalid={invalid}
        placeholder={placeholder}
        onLeave={() => commandsOf(session).leave()}
      />
    </div>
  );
}
