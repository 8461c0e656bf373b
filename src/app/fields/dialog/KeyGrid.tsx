import type { PointerEvent, ReactNode } from "react";
import { erase, insert, toggleSign, type EntryState } from "../number/number-entry.ts";
import type { DialogTexts } from "../../../i18n/en/workplace/dialog.ts";

/** One key of a keypad. */
export interface PadKey {
  readonly label: ReactNode;
  readonly name: string;
  readonly press: () => void;
  readonly className?: string;
  readonly disabled?: boolean;
}

/** Pressing a key leaves the caret where it is. */
const keepFocus = (event: PointerEvent) => event.preventDefault();

/** The keys that write into a number: sums, the sign, the decimal sign, erasing; every other one writes itself. */
export function writingKeys(
  t: DialogTexts["keys"],
  sign: string,
  numeric: boolean,
  change: (by: (entry: EntryState) => EntryState) => () => void,
): (id: string) => PadKey {
  const written = (label: string, character: string, name: string): PadKey => ({
    label,
    name,
    press: change((entry) => insert(entry, character)),
    className: "number",
    disabled: !numeric,
  });
  const keys: Readonly<Record<string, PadKey>> = {
    "/": written("÷", "/", t.dividedLong),
    "*": written("×", "*", t.timesLong),
    "-": written("−", "-", t.minusLong),
    "+": written("+", "+", t.plusLong),
    "(": written("(", "(", t.bracketOpen),
    ")": written(")", ")", t.bracketClose),
    Q: written(t.parameter, "Q", t.parameterLong),
    point: written(sign, sign, t.point),
    sign: { label: t.sign, name: t.signLong, press: change(toggleSign), className: "number", disabled: !numeric },
    erase: { label: t.erase, name: t.eraseLong, press: change(erase), disabled: !numeric },
  };
  return (id) => keys[id] ?? written(id, id, id);
}

/** A key; `tabbed: false` keeps it out of the tab order, so that its field keeps the focus. */
export const padButton = ({ label, name, press, className = "", disabled = false }: PadKey, tabbed = true) => (
  <button
    key={name}
    type="button"
    className={`button key ${className}`}
    aria-label={name}
    disabled={disabled}
    onPointerDown={keepFocus}
    tabIndex={tabbed ? undefined : -1}
    onClick={press}
  >
    {label}
  </button>
);
