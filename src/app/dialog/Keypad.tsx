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

/** The keys of the control for fingers, docked under the open prompt. */
export function Keypad({ q, param, field }: Props) {
  const t = useTexts().dialog;
  const sign = decimalSign(useSettings((s) => s.language));
  const change = (by: (entry: Entry) => Entry) => {
    const open = field.current;
    if (!open) return;
    open.focus();
    open.write(by(open.read()));
  };
  const digit = (d: number) => {
    if (!param.choices) change((entry) => insert(entry, String(d)));
    else if (param.choices.includes(d)) {
      closeStep();
      setPrompt(q, String(d));
    }
  };
  const numeric = !param.choices;
  const key = (label: React.ReactNode, name: string, press: () => void, options: { className?: string; disabled?: boolean } = {}) => (
    <button
      type="button" className={`button key ${options.className ?? ""}`} aria-label={name} disabled={options.disabled ?? false}
      onPointerDown={keepFocus} onClick={press}
    >
      {label}
    </button>
  );
  const digits = (row: readonly number[]) =>
    row.map((d) => <span key={d} className="key-slot">{key(d, String(d), () => digit(d), { className: "number", disabled: !numeric && !param.choices?.includes(d) })}</span>);

  const written = (label: string, character: string, name: string) =>
    key(label, name, () => change((entry) => insert(entry, character)), { className: "number", disabled: !numeric });

  return (
    <div className="keypad" role="group" aria-label={t.keypad}>
      {digits([7, 8, 9])}
      {written("÷", "/", t.keys.dividedLong)}
      {key(<Icon name="up" />, t.keys.previous, () => step(-1))}
      {key(t.keys.erase, t.keys.eraseLong, () => change(erase), { disabled: !numeric })}
      {digits([4, 5, 6])}
      {written("×", "*", t.keys.timesLong)}
      {key(<Icon name="down" />, t.keys.next, () => step(1))}
      {key(t.keys.noEnter, t.keys.noEnterLong, noEntry, { className: "small", disabled: !param.optional })}
      {digits([1, 2, 3])}
      {written("−", "-", t.keys.minusLong)}
      {key("CE", t.keys.cancel, cancel)}
      {key(t.keys.end, t.keys.endLong, finish)}
      {key(t.keys.sign, t.keys.signLong, () => change(toggleSign), { className: "number", disabled: !numeric })}
      {digits([0])}
      {key(sign, t.keys.point, () => change((entry) => insert(entry, sign)), { className: "number", disabled: !numeric })}
      {written("+", "+", t.keys.plusLong)}
      {written(t.keys.parameter, "Q", t.keys.parameterLong)}
      {key(t.keys.enter, t.keys.enterLong, () => step(1), { className: "primary enter" })}
    </div>
  );
}
