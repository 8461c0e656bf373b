import type { PointerEvent, ReactNode } from "react";
import { decimalSign } from "../../i18n/number.ts";
import { erase, insert, toggleSign, type Entry } from "../dialog/number-entry.ts";
import { Icon } from "../Icon.tsx";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import type { PromptActions } from "./use-prompts.ts";

const keepFocus = (event: PointerEvent) => event.preventDefault();

/** The keys of the control for fingers, under the open prompt. */
export function ApproachKeypad({ actions, change, numeric, optional, incremental }: {
  readonly actions: PromptActions;
  /** Changes the text of the open field. */
  readonly change: (by: (entry: Entry) => Entry) => void;
  readonly numeric: boolean;
  readonly optional: boolean;
  readonly incremental: boolean;
}) {
  const t = useTexts(), { keys, keypad } = t.dialog;
  const sign = decimalSign(useSettings((s) => s.language));
  const key = (label: ReactNode, name: string, press: () => void, more: { className?: string; disabled?: boolean } = {}) => (
    <button key={name} type="button" className={`button key ${more.className ?? ""}`} aria-label={name} disabled={more.disabled ?? false} onPointerDown={keepFocus} onClick={press}>
      {label}
    </button>
  );
  const digits = (row: readonly number[]) => row.map((d) => key(d, String(d), () => change((e) => insert(e, String(d))), { className: "number", disabled: !numeric }));
  const toggleIncremental = (e: Entry): Entry => (/^I/i.test(e.text) ? { ...e, text: e.text.slice(1), from: 0, to: e.text.length - 1 } : { ...e, text: `I${e.text}`, from: e.from + 1, to: e.to + 1 });
  return (
    <div className="keypad approach-keypad" role="group" aria-label={keypad}>
      {digits([7, 8, 9])}
      {key(<Icon name="up" />, keys.previous, () => actions.step(-1))}
      {key(keys.erase, keys.eraseLong, () => change(erase), { disabled: !numeric })}
      {key(keys.noEnter, keys.noEnterLong, actions.noEntry, { className: "small", disabled: !optional })}
      {key(keys.end, keys.endLong, actions.finish)}
      {digits([4, 5, 6])}
      {key(<Icon name="down" />, keys.next, () => actions.step(1))}
      {key(keys.sign, keys.signLong, () => change(toggleSign), { className: "number", disabled: !numeric })}
      {key(sign, keys.point, () => change((e) => insert(e, sign)), { className: "number", disabled: !numeric })}
      {key("I", t.approach.incremental, () => change(toggleIncremental), { disabled: !incremental })}
      {digits([1, 2, 3, 0])}
      {key(keys.enter, keys.enterLong, () => actions.step(1), { className: "primary enter" })}
    </div>
  );
}
