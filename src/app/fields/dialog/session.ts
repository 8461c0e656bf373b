import type { ReactNode } from "react";
import type { FieldReading } from "../../../program/values/field.ts";
import { valueAsTyped } from "../../../program/values/typed-value.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { closeStep } from "../../document/steps.ts";

/** One prompt of a dialog, in the words of the screen. */
export interface Prompt {
  readonly id: string;
  /** How it is written on the screen: Q493, LEN, RL/RR. */
  readonly letter: string;
  readonly question: string;
  readonly label: string;
  readonly about: string;
  /** Its page in the guide, where it has one. */
  readonly page?: readonly string[];
  /** Accessible name of its input. */
  readonly name: string;
  readonly unit: string;
  /** Smallest and largest value; null where it has none. */
  readonly range: string | null;
  /** Notes besides the range: optional, incremental. */
  readonly notes: readonly string[];
  /** Printed values with their meanings, where only these may be taken. */
  readonly choices: readonly { readonly value: string; readonly meaning: string }[] | null;
  readonly optional: boolean;
  /** Has no effect with the other values: ENT skips it, and it may be omitted. */
  readonly idle: boolean;
  /** May have an I in front. */
  readonly increments: boolean;
  /** FAUTO has a button of its own. */
  readonly auto: boolean;
  readonly decimals: number;
  /** What the list of prompts shows. */
  readonly shown: { readonly text: string; readonly unit: string; readonly soft: boolean };
  /** Suggestion for the empty field. ENT takes it; a field of the set-up follows it until then. */
  readonly suggestion?: string | undefined;
  /** Set-up group, before the prompts of the cycle; a closed group is one row of the list. */
  readonly group?: PromptGroup;
  /** Has no value, only an action. */
  readonly hasNoValue?: true;
  /** A place outside the dialog that it leads to; `needed`: ENT goes there first. */
  readonly action?: { readonly label: string; readonly run: () => void; readonly needed: boolean };
}

/** Properties that a prompt copies from the description of its value. */
type PromptField = Pick<Prompt, "id"> & Partial<Pick<Prompt, "letter" | "optional" | "increments" | "decimals">>;

/** The texts of a prompt; `label`: in the list, where that is not the question. */
interface PromptWords {
  readonly prompt: string;
  readonly label?: string;
  readonly about: string;
}

/**
 * A prompt with defaults: a required number without unit and bounds, always in effect, of three decimals. `more`
 * overrides them.
 */
export const promptOf = (
  { id, letter = id, optional = false, increments = false, decimals = 3 }: PromptField,
  { prompt, label = prompt, about }: PromptWords,
  more: Pick<Prompt, "name" | "shown"> & Partial<Prompt>,
): Prompt => ({
  id,
  letter,
  question: prompt,
  label,
  about,
  unit: "",
  range: null,
  notes: [],
  choices: null,
  optional,
  idle: false,
  increments,
  auto: false,
  decimals,
  ...more,
});

export interface PromptGroup {
  readonly id: string;
  readonly letter: string;
  readonly name: string;
  readonly text: string;
  readonly unit: string;
  readonly soft: boolean;
  /** Position in the set-up, and number of positions. */
  readonly at: readonly [number, number];
}

/** Which prompt is open. */
export interface Opened {
  /** Null at the end of the dialog. */
  readonly id: string | null;
  /** The text as it was when the prompt opened, for Escape. */
  readonly before: string;
  /** Incremented when the open field should take the focus. */
  readonly focus: number;
}

/** A dialog of prompts, whatever it writes: the job, a cycle block of a program, an approach. */
export interface PromptSession {
  readonly fields: readonly Prompt[];
  readonly draft: Readonly<Record<string, string>>;
  readonly readings: Readonly<Record<string, FieldReading>>;
  readonly set: (id: string, text: string) => void;
  readonly findings: readonly FindingEntry[];
  /** Findings of other places that concern a prompt, with the name of their place. */
  readonly otherFindings: (id: string) => readonly { readonly entry: FindingEntry; readonly place?: string }[];
  readonly picture: ReactNode;
  readonly opened: Opened;
  readonly open: (id: string | null, before: string) => void;
  /** True if a prompt may take the focus when it opens. */
  readonly mayFocus: () => boolean;
  /** The set-up has fields for the values of Q parameters. */
  readonly asksParameters: boolean;
  /** Prompts without effect once a prompt has this answer; called before the answer is stored. */
  readonly idleWith?: (id: string, text: string) => (other: string) => boolean;
  /** Takes several answers in one step of undo. */
  readonly setAll?: (texts: Readonly<Record<string, string>>) => void;
  /** Touch keypad: calculator or path words. */
  readonly keypad: "sums" | "words";
}

export const openPromptOf = ({ fields, opened }: PromptSession): Prompt | null =>
  fields.find((f) => f.id === opened.id) ?? null;

/** Suggestion for an empty prompt; null if it is answered. */
export function suggestionFor(
  { draft }: Pick<PromptSession, "draft">,
  { id, suggestion, idle }: Prompt,
): string | null {
  return suggestion !== undefined && !idle && (draft[id] ?? "").trim() === "" ? suggestion : null;
}

/** Suggestions for all unanswered prompts that have an effect. */
export function openSuggestions(session: PromptSession): Readonly<Record<string, string>> {
  const all = session.fields.flatMap((f) => {
    const text = suggestionFor(session, f);
    return text === null || session.readings[f.id]?.issue === null ? [] : [[f.id, text] as const];
  });
  return Object.fromEntries(all.filter(([id]) => !all.some(([other, text]) => session.idleWith?.(other, text)(id))));
}

/** The text after its field is left: a sum becomes its value; with a Q parameter only if that has a value. */
function settled(reading: FieldReading | undefined, text: string): string {
  const { value, written, computed, incremental } = reading ?? {
    value: null,
    written: null,
    computed: false,
    incremental: false,
  };
  const sign = incremental ? "I" : "";
  if (written === "auto" || written === "max") return `F${written.toUpperCase()}`;
  if (value !== null && computed) return sign + String(value);
  if (value !== null && typeof written === "object") return sign + valueAsTyped(written);
  return text.trim();
}

/** What the keys of the control do in a dialog. */
export interface PromptCommands {
  /** Leaves the open prompt: evaluates its text and starts a new step of undo. */
  readonly leave: () => void;
  /** Opens a prompt after leaving the one before it. */
  readonly goTo: (id: string | null) => void;
  /** ENT: the next prompt that has an effect; after the last one the dialog ends. */
  readonly enter: () => void;
  /** Moves by `by` prompts; the dialog ends after the last one and stays at the first. */
  readonly step: (by: number) => void;
  /** NO ENT: omits the prompt, if allowed. */
  readonly noEntry: () => void;
  /** END: the rest stays as it is. */
  readonly finish: () => void;
  /** Escape: the value as it was when the prompt opened. */
  readonly cancel: () => void;
  /** Sets a value by a button, as its own step of undo. */
  readonly take: (text: string) => void;
}

export function commandsOf(session: PromptSession): PromptCommands {
  const { fields, draft, opened, set } = session;
  const open = openPromptOf(session);
  const at = open ? fields.indexOf(open) : -1;
  const text = (id: string | null) => (id === null ? "" : (draft[id] ?? ""));
  const show = (id: string | null) => session.open(id, text(id));
  const nextOf = (by: number) => (at >= 0 ? at + by : by > 0 ? 0 : fields.length - 1);
  const onwards = (idle = (f: Prompt) => f.idle) => fields.slice(nextOf(1)).find((f) => !idle(f))?.id ?? null;
  const leave = () => {
    const typed = text(opened.id);
    const stays = open && settled(session.readings[open.id], typed);
    if (open && stays !== null && stays !== typed) set(open.id, stays);
    closeStep();
  };
  const goTo = (id: string | null) => {
    leave();
    show(id);
  };
  const take = (value: string) => {
    if (!open) return;
    closeStep();
    set(open.id, value);
    closeStep();
  };
  return {
    leave,
    goTo,
    take,
    finish: () => goTo(open?.group ? (fields.find((f) => !f.group)?.id ?? null) : null),
    enter() {
      if (open?.action?.needed) return open.action.run();
      const suggested = open && suggestionFor(session, open);
      if (!open || suggested === null) return goTo(onwards());
      take(suggested);
      const idle = session.idleWith?.(open.id, suggested);
      show(onwards(idle && ((f) => idle(f.id))));
    },
    step(by) {
      const next = nextOf(by);
      if (next >= 0) goTo(fields[next]?.id ?? null);
    },
    noEntry() {
      if (!open?.optional && !open?.idle) return;
      take("");
      show(onwards());
    },
    cancel() {
      if (!open) return;
      closeStep();
      set(open.id, opened.before);
      session.open(open.id, opened.before);
    },
  };
}
