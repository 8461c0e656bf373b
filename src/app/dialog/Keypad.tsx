import type { PointerEvent, ReactNode, RefObject } from "react";
import { decimalSign } from "../../i18n/number.ts";
import { Icon } from "../Icon.tsx";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { erase, insert, toggleIncremental, toggleSign, type EntryState } from "./number-entry.ts";
import { commandsOf, type Prompt, type PromptSession } from "./session.ts";
import type { ValueField } from "./ValueInput.tsx";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly input: RefObject<ValueField | null>;
}

interface Key {
  readonly label: ReactNode;
  readonly name: string;
  readonly press: () => void;
  readonly className?: string;
  readonly disabled?: boolean;
}

/** Pressing a key leaves the caret where it is. */
const keepFocus = (event: PointerEvent) => event.preventDefault();

/** The keys in their rows: a calculator with the keys of the control beside it, and the keys of path words. */
const ROWS = {
  sums: "7 8 9 / up erase 4 5 6 * down noEnter 1 2 3 - cancel end sign 0 point + Q enter".split(" "),
  words: "7 8 9 up erase noEnter end 4 5 6 down sign point I 1 2 3 0 enter".split(" "),
} as const;

/** The keys of the control for fingers, docked under the open prompt. Of a choice among digits only its own are there. */
export function Keypad({ session, prompt, input }: Props) {
  const { dialog: { keys: t, keypad }, approach } = useTexts();
  const sign = decimalSign(useSettings((s) => s.language));
  const { enter, step, noEntry, cancel, finish, take } = commandsOf(session);
  const numeric = prompt.choices === null;
  const change = (by: (entry: EntryState) => EntryState) => () => {
    const open = input.current;
    if (!open) return;
    open.focus();
    open.write(by(open.read()));
  };
  const written = (label: string, character: string, name: string): Key => ({
    label,
    name,
    press: change((entry) => insert(entry, character)),
    className: "number",
    disabled: !numeric,
  });
  const keys: Readonly<Record<string, Key>> = {
    "/": written("÷", "/", t.dividedLong),
    "*": written("×", "*", t.timesLong),
    "-": written("−", "-", t.minusLong),
    "+": written("+", "+", t.plusLong),
    Q: written(t.parameter, "Q", t.parameterLong),
    point: written(sign, sign, t.point),
    I: { label: "I", name: approach.incremental, press: change(toggleIncremental), disabled: !prompt.increments },
    sign: { label: t.sign, name: t.signLong, press: change(toggleSign), className: "number", disabled: !numeric },
    erase: { label: t.erase, name: t.eraseLong, press: change(erase), disabled: !numeric },
    up: { label: <Icon name="up" />, name: t.previous, press: () => step(-1) },
    down: { label: <Icon name="down" />, name: t.next, press: () => step(1) },
    noEnter: { label: t.noEnter, name: t.noEnterLong, press: noEntry, className: "small", disabled: !prompt.optional && !prompt.idle },
    cancel: { label: "CE", name: t.cancel, press: cancel },
    end: { label: t.end, name: t.endLong, press: finish },
    enter: { label: t.enter, name: t.enterLong, press: enter, className: "primary enter" },
  };
  const keyOf = (id: string): Key => keys[id] ?? written(id, id, id);
  const button = ({ label, name, press, className = "", disabled = false }: Key) => (
    <button key={name} type="button" className={`button key ${className}`} aria-label={name} disabled={disabled} onPointerDown={keepFocus}
      onClick={press}
    >
      {label}
    </button>
  );

  if (prompt.choices && session.keypad === "sums") {
    return (
      <div className="keypad" role="group" aria-label={keypad}>
        {prompt.choices.map(({ value }) => button({ label: value, name: value, press: () => take(value), className: "number" }))}
        <span className="key-rest" />
        {["up", "down", "cancel", "noEnter", "end", "enter"].map((id) => button(keyOf(id)))}
      </div>
    );
  }
  return (
    <div className={`keypad${session.keypad === "words" ? " approach-keypad" : ""}`} role="group" aria-label={keypad}>
      {ROWS[session.keypad].map((id) => button(keyOf(id)))}
    </div>
  );
}
