import { useEffectEvent, useLayoutEffect, useRef } from "react";
import { Radio, RadioGroup, type RadioProps } from "react-aria-components/RadioGroup";
import { closeStep } from "../../document/steps.ts";
import { suggestionFor, type Prompt, type PromptSession } from "./session.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly choices: NonNullable<Prompt["choices"]>;
  readonly describedBy: string;
}

type KeyboardEvent = Parameters<NonNullable<RadioProps["onKeyDown"]>>[0];

/** The printed values of a choice with their meanings. A digit key takes one, left and right move, ENT goes on. */
export function ChoiceInput({ session, prompt, choices, describedBy }: Props) {
  const { id, name } = prompt;
  const suggested = suggestionFor(session, prompt);
  const group = useRef<HTMLDivElement>(null);
  const typed = (session.draft[id] ?? "").trim();
  const chosen = choices.find(({ value }) => value === typed || (typed !== "" && Number(value) === Number(typed)));
  const radio = (value: string | undefined) =>
    group.current?.querySelector<HTMLInputElement>(`input[value="${value}"]`);
  const opened = useEffectEvent(() => {
    if (session.mayFocus()) radio(chosen?.value ?? suggested ?? choices[0]?.value)?.focus({ preventScroll: true });
  });
  useLayoutEffect(() => opened(), [id, session.opened.focus]);

  const take = (value: string) => {
    closeStep();
    session.set(id, value);
  };
  const onDigit = (event: KeyboardEvent) => {
    const named = choices.find(({ value }) => value === event.key);
    if (!named) return event.continuePropagation();
    take(named.value);
    radio(named.value)?.focus({ preventScroll: true });
  };

  return (
    <RadioGroup
      ref={group}
      className="choices"
      name={id}
      aria-label={name}
      aria-describedby={describedBy}
      value={chosen?.value ?? null}
      onChange={take}
    >
      {choices.map(({ value, meaning }) => (
        <Radio
          key={value}
          value={value}
          className={`choice radio${value === suggested ? " suggested" : ""}`}
          onKeyDown={onDigit}
        >
          <span className="number choice-number">{value}</span>
          <span>{meaning}</span>
        </Radio>
      ))}
    </RadioGroup>
  );
}
