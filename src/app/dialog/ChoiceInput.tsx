import { useEffectEvent, useLayoutEffect, useRef } from "react";
import { closeStep } from "../store.ts";
import type { Prompt, PromptSession } from "./session.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly choices: NonNullable<Prompt["choices"]>;
  readonly describedBy: string;
}

/** The printed values of a choice with their meanings. A digit key takes one, left and right move, ENT goes on. */
export function ChoiceInput({ session, prompt: { id, name }, choices, describedBy }: Props) {
  const group = useRef<HTMLFieldSetElement>(null);
  const typed = (session.draft[id] ?? "").trim();
  const chosen = choices.findIndex(({ value }) => value === typed || (typed !== "" && Number(value) === Number(typed)));
  const opened = useEffectEvent(() => {
    if (!session.mayFocus()) return;
    const radios = group.current?.querySelectorAll("input");
    const current = group.current?.querySelector<HTMLInputElement>("input:checked");
    (current ?? radios?.[0])?.focus({ preventScroll: true });
  });
  useLayoutEffect(() => opened(), [id, session.opened.focus]);

  const take = (at: number) => {
    const choice = choices[at];
    if (!choice) return;
    closeStep();
    session.set(id, choice.value);
    group.current?.querySelectorAll("input")[at]?.focus({ preventScroll: true });
  };

  return (
    <fieldset ref={group} className="choices" role="radiogroup" aria-label={name} aria-describedby={describedBy} onKeyDown={(event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      const named = choices.findIndex(({ value }) => value === event.key);
      if (by === 0 && named < 0) return;
      event.preventDefault();
      take(by === 0 ? named : Math.min(choices.length - 1, Math.max(0, chosen + by)));
    }}>
      {choices.map(({ value, meaning }, i) => (
        <label key={value} className="choice">
          <input type="radio" name={id} value={value} checked={i === chosen} onChange={() => take(i)} />
          <span className="number choice-number">{value}</span>
          <span>{meaning}</span>
        </label>
      ))}
    </fieldset>
  );
}
