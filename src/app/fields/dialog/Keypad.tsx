import type { RefObject } from "react";
import { decimalSign } from "../../../i18n/number.ts";
import { Icon } from "../../base/Icon.tsx";
import { useMedia } from "../../base/use-media.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { fieldEntry, writeEntry } from "../keypad/field-typing.ts";
import { toggleIncremental, type EntryState } from "../number/number-entry.ts";
import { KEY_ROWS } from "./key-rows.ts";
import { padButton, writingKeys, type PadKey } from "./KeyGrid.tsx";
import { commandsOf, type Prompt, type PromptSession } from "./session.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly input: RefObject<HTMLInputElement | null>;
}

/** Touch keypad docked below the open prompt. A choice among digits shows only its own digits. */
export function Keypad({ session, prompt, input }: Props) {
  const {
    dialog: { keys: t, keypad },
    approach,
  } = useTexts();
  const sign = decimalSign(useSettings((s) => s.language));
  const { enter, step, noEntry, cancel, finish, take } = commandsOf(session);
  const numeric = prompt.choices === null;
  const change = (by: (entry: EntryState) => EntryState) => () => {
    const open = input.current;
    if (!open) return;
    open.focus({ preventScroll: true });
    writeEntry(open, by(fieldEntry(open)));
  };
  const writing = writingKeys(t, sign, numeric, change);
  const keys: Readonly<Record<string, PadKey>> = {
    I: { label: "I", name: approach.incremental, press: change(toggleIncremental), disabled: !prompt.increments },
    up: { label: <Icon name="up" />, name: t.previous, press: () => step(-1), className: "key-command" },
    down: { label: <Icon name="down" />, name: t.next, press: () => step(1), className: "key-command" },
    noEnter: {
      label: t.noEnter,
      name: t.noEnterLong,
      press: noEntry,
      className: "small key-command",
      disabled: !prompt.optional && !prompt.idle,
    },
    cancel: { label: "CE", name: t.cancel, press: cancel, className: "key-command" },
    end: { label: t.end, name: t.endLong, press: finish, className: "key-command" },
    enter: { label: t.enter, name: t.enterLong, press: enter, className: "primary key-command enter" },
  };
  const flat = useMedia("flat") && session.keypad === "sums";
  const keyOf = (id: string): PadKey => keys[id] ?? writing(id);

  if (prompt.choices && session.keypad === "sums") {
    return (
      <div className="keypad" role="group" aria-label={keypad}>
        {prompt.choices.map(({ value }) =>
          padButton({ label: value, name: value, press: () => take(value), className: "number" }),
        )}
        <span className="key-rest" />
        {["up", "down", "cancel", "noEnter", "end", "enter"].map((id) => padButton(keyOf(id)))}
      </div>
    );
  }
  return (
    <div className={`keypad${flat ? " flat" : ""}`} role="group" aria-label={keypad}>
      {KEY_ROWS[flat ? "flatSums" : session.keypad].map((id) => padButton(keyOf(id)))}
    </div>
  );
}
