import type { PointerEvent, RefObject } from "react";
import type { Param } from "../../cycles/params.ts";
import { decimalSign } from "../../i18n/number.ts";
import { Icon } from "../Icon.tsx";
import { setPrompt } from "../edits.ts";
import { closeStep } from "../store.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { erase, insert, toggleSign, type Entry } from "./number-entry.ts";
import { cancel, finish, noEntry, step } from "./prompts.ts";
import type { ValueField } from "./ValueInput.tsx";

interface Props {
  readonly q: string;
  readonly param: Param;
  readonly field: RefObject<ValueField | null>;
}

/** Pressing a key leaves the caret where it is. */
const keepFocus = (event: PointerEvent) => event.preventDefault();

/** The keys of the control for fingers, docked under the open prompt. Of a choice only its own digits are there. */
export function Keypad({ q, param, field }: Props) {
  const t = useTexts().dialog;
  const sign = decimalSign(useSettings((s) => s.language));
  const take = (choice: number) => {
    closeStep();
    setPrompt(q, String(choice));
  };
  const change = (by: (entry: Entry) => Entry) => {
    const open = field.current;
    if (!open) return;
    open.focus();
    open.write(by(open.read()));
  };
  const key = (label: React.ReactNode, name: string, press: () => void, options: { className?: string; disabled?: boolean } = {}) => (
    <button
      type="button" className={`button key ${options.className ?? ""}`} aria-label={name} disabled={options.disabled ?? false}
      onPointerDown={keepFocus} onClick={press}
    >
      {label}
    </button>
  );
  const digits = (row: readonly number[]) =>
    row.map((d) => <span key={d} className="key-slot">{key(d, String(d), () => change((entry) => insert(entry, String(d))), { className: "number" })}</span>);

  const written = (label: string, character: string, name: string) =>
    key(label, name, () => change((entry) => insert(entry, character)), { className: "number" });

  const previous = key(<Icon name="up" />, t.keys.previous, () => step(-1));
  const next = key(<Icon name="down" />, t.keys.next, () => step(1));
  const without = key(t.keys.noEnter, t.keys.noEnterLong, noEntry, { className: "small", disabled: !param.optional });
  const restore = key("CE", t.keys.cancel, cancel);
  const end = key(t.keys.end, t.keys.endLong, finish);
  const enter = key(t.keys.enter, t.keys.enterLong, () => step(1), { className: "primary enter" });

  if (param.choices) {
    return (
      <div className="keypad" role="group" aria-label={t.keypad}>
        {param.choices.map((choice) => <span key={choice} className="key-slot">{key(choice, String(choice), () => take(choice), { className: "number" })}</span>)}
        <span className="key-rest" />
        {previous}{next}{restore}{without}{end}{enter}
      </div>
    );
  }
  return (
    <div className="keypad" role="group" aria-label={t.keypad}>
      {digits([7, 8, 9])}
      {written("÷", "/", t.keys.dividedLong)}
      {previous}
      {key(t.keys.erase, t.keys.eraseLong, () => change(erase))}
      {digits([4, 5, 6])}
      {written("×", "*", t.keys.timesLong)}
      {next}
      {without}
      {digits([1, 2, 3])}
      {written("−", "-", t.keys.minusLong)}
      {restore}
      {end}
      {key(t.keys.sign, t.keys.signLong, () => change(toggleSign), { className: "number" })}
      {digits([0])}
      {key(sign, t.keys.point, () => change((entry) => insert(entry, sign)), { className: "number" })}
      {written("+", "+", t.keys.plusLong)}
      {written(t.keys.parameter, "Q", t.keys.parameterLong)}
      {enter}
    </div>
  );
}
