import { useLayoutEffect, useRef } from "react";
import type { Param } from "../../cycles/params.ts";
import { setPrompt } from "../edits.ts";
import { mayTakeKeyboard, usePlace } from "../place.ts";
import { closeStep } from "../store.ts";

interface Props {
  readonly q: string;
  readonly param: Param;
  readonly text: string;
  readonly name: string;
  readonly describedBy: string;
  readonly meanings: Readonly<Record<number, string>>;
}

/** The printed numbers of a choice with their meanings. A digit key takes one, left and right move, ENT goes on. */
export function ChoiceInput({ q, param, text, name, describedBy, meanings }: Props) {
  const group = useRef<HTMLFieldSetElement>(null);
  const focus = usePlace((p) => p.focus);
  const choices = param.choices ?? [];
  const chosen = choices.indexOf(text.trim() === "" ? Number.NaN : Number(text));

  useLayoutEffect(() => {
    if (!mayTakeKeyboard()) return;
    const radios = group.current?.querySelectorAll("input");
    const current = group.current?.querySelector<HTMLInputElement>("input:checked");
    (current ?? radios?.[0])?.focus({ preventScroll: true });
  }, [q, focus]);

  const take = (choice: number | undefined) => {
    if (choice === undefined) return;
    closeStep();
    setPrompt(q, String(choice));
    group.current?.querySelectorAll("input")[choices.indexOf(choice)]?.focus({ preventScroll: true });
  };

  return (
    <fieldset
      ref={group}
      className="choices"
      role="radiogroup"
      aria-label={name}
      aria-describedby={describedBy}
      onKeyDown={(event) => {
        const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (by !== 0) {
          event.preventDefault();
          take(choices[Math.min(choices.length - 1, Math.max(0, chosen + by))]);
        } else if (choices.includes(Number(event.key)) && event.key.trim() !== "") {
          event.preventDefault();
          take(Number(event.key));
        }
      }}
    >
      {choices.map((choice, i) => (
        <label key={choice} className="choice">
          <input type="radio" name={q} value={choice} checked={i === chosen} onChange={() => take(choice)} />
          <span className="number choice-number">{choice}</span>
          <span>{meanings[choice] ?? ""}</span>
        </label>
      ))}
    </fieldset>
  );
}
