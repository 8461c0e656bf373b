import { z } from "zod/mini";
import { measure } from "../../program/files/bounded.ts";
import { materialId, type Task } from "../task.ts";
import { inLanguages, type InLanguages } from "../words.ts";
import { FAULT_KINDS, type FaultKind } from "./faults.ts";
import { ASKED_KINDS, type QuestionDraft } from "./question-draft.ts";
import type { ThreadDraft } from "./made-threads.ts";

/** Rules that a form switches on and off, each with one number. */
export const NUMBER_RULES = ["depth", "speed", "mostTools", "seconds", "passes", "residue", "missing", "rz"] as const;
export type NumberRule = (typeof NUMBER_RULES)[number];
/** Rules that are lists of numbers. */
export const LIST_RULES = ["cycles"] as const;
export type ListRule = (typeof LIST_RULES)[number];

export const TOOL_OFFERS = ["called", "listed", "all"] as const;
export type OfferKind = (typeof TOOL_OFFERS)[number];

/** A rule in the form: whether it applies, and its number or numbers as typed. */
export interface RuleDraft {
  readonly on: boolean;
  readonly text: string;
}

/** A size that may be checked, with its deviations as typed, mm. */
export interface SizeDraft {
  readonly kind: "diameter" | "bore" | "face";
  readonly at: number;
  readonly nominal: number;
  readonly on: boolean;
  readonly upper: string;
  readonly lower: string;
}

/** Prompts of the starting state: the cycle call, from 0, and its values that are empty. */
export interface PromptsDraft {
  readonly operation: number;
  readonly emptied: readonly string[];
}

export interface WordsDraft {
  readonly title: string;
  readonly ask: string;
  readonly hints: readonly [string, string, string];
}

/** The form of a task, as typed. */
export interface TaskForm {
  /** The texts in further languages. Forms stored before there were any lack the field. */
  readonly translations?: InLanguages<WordsDraft> | undefined;
  readonly kind: Task["kind"];
  /** Lines of the blank and the outlines; all empty where only the rules count. */
  readonly blank: string;
  readonly outside: string;
  readonly bore: string;
  readonly threads: readonly ThreadDraft[];
  /** Id of a shipped material; null for none. */
  readonly material: NonNullable<Task["material"]> | null;
  readonly sizes: readonly SizeDraft[];
  readonly rules: Readonly<Record<NumberRule | ListRule, RuleDraft>>;
  /** The tools in the learner's table: those that the answer calls, those of the list, or all. */
  readonly offer: OfferKind;
  readonly tools: readonly number[];
  readonly clean: boolean;
  /** Questions before the run, for the kinds that have any. */
  readonly questions: readonly QuestionDraft[];
  readonly start: "empty" | "prompts" | "program";
  readonly prompts: PromptsDraft;
  readonly faults: readonly FaultKind[];
  /** The starting program, if edited; null while it is the answer with its faults. */
  readonly program: string | null;
  readonly words: WordsDraft;
}

/** Greatest length of a text, characters, and of a list. */
const LONGEST = 100_000,
  MOST = 200;
const text = z.string().check(z.maxLength(LONGEST));
const many = <S extends z.core.$ZodType>(schema: S) => z.array(schema).check(z.maxLength(MOST));
const rule = z.object({ on: z.boolean(), text });
const finite = measure;
const wordsShape = z.object({ title: text, ask: text, hints: z.tuple([text, text, text]) });

/** A form as stored. */
export const formShape = z.object({
  kind: z.enum(["make", "fault", "predict", "drawing"]),
  blank: text,
  outside: text,
  bore: text,
  threads: many(
    z.object({ from: finite, to: finite, crest: finite, root: finite, pitch: finite, name: text, on: z.boolean() }),
  ),
  // Forms stored before the field existed have no material.
  material: z._default(z.nullable(materialId), null),
  sizes: many(
    z.object({
      kind: z.enum(["diameter", "bore", "face"]),
      at: finite,
      nominal: finite,
      on: z.boolean(),
      upper: text,
      lower: text,
    }),
  ),
  rules: z.object({
    depth: rule,
    speed: rule,
    mostTools: rule,
    seconds: rule,
    passes: rule,
    residue: rule,
    missing: rule,
    rz: rule,
    cycles: rule,
  }),
  offer: z.enum(TOOL_OFFERS),
  tools: many(finite),
  clean: z.boolean(),
  questions: many(
    z.object({
      ask: z.enum(ASKED_KINDS),
      text,
      operation: z.nullable(z.int()),
      at: text,
      within: text,
      choices: text,
      right: text,
      translations: z.optional(inLanguages(z.object({ text, choices: text }))),
    }),
  ),
  start: z.enum(["empty", "prompts", "program"]),
  prompts: z.object({ operation: z.int(), emptied: many(text) }),
  faults: many(z.enum(FAULT_KINDS)),
  program: z.nullable(text),
  words: wordsShape,
  translations: z.optional(inLanguages(wordsShape)),
});

/** A proposed number with the decimal sign of a language; both signs can be read. */
export const withSign = (text: string, sign: string): string => text.replace(".", sign);

/** A form with its numbers in the decimal sign of a language; lists of whole numbers are unchanged. */
export const formWithSign = (form: TaskForm, sign: string): TaskForm => ({
  ...form,
  rules: Object.fromEntries(
    Object.entries(form.rules).map(([name, { on, text: number }]) => [name, { on, text: withSign(number, sign) }]),
  ) as TaskForm["rules"],
  sizes: form.sizes.map((size) => ({ ...size, upper: withSign(size.upper, sign), lower: withSign(size.lower, sign) })),
  questions: form.questions.map((each) => ({
    ...each,
    at: withSign(each.at, sign),
    within: withSign(each.within, sign),
  })),
});

/** A form from storage; null where the data are no form. Never throws. */
export function readForm(raw: unknown): TaskForm | null {
  const read = formShape.safeParse(raw);
  return read.success ? read.data : null;
}
