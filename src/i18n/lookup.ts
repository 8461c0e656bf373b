import type { CycleNumber, ParamTextId } from "../cycles/index.ts";
import type { Kind } from "../cycles/params.ts";
import type { CycleText } from "./cycle-text.ts";
import { texts } from "./index.ts";
import type { Language } from "./languages.ts";
import type { AnyIssue } from "./message-texts.ts";
import type { ChoiceText, ParamText } from "./param-text.ts";
import { writer, type Write } from "./write.ts";

/** The sentence of a finding; `kind` is what its field measures, so that a diameter is written with its sign. */
export function message(language: Language, found: AnyIssue, kind?: Kind): string {
  const sentence = texts(language).messages.of[found.code] as (data: object, write: Write) => string;
  return sentence(found.data, writer(language, kind));
}

/** Texts of a parameter, by its text key in the catalogue. */
export const paramText = (language: Language, text: string): ParamText =>
  texts(language).params[text as ParamTextId];

/** Meaning of a number of a choice; null for other parameters and numbers. */
export function choiceMeaning(language: Language, text: string, choice: number): string | null {
  const found: ParamText | ChoiceText = texts(language).params[text as ParamTextId];
  return "choices" in found ? (found.choices[choice] ?? null) : null;
}

/** Texts of a cycle of the catalogue. */
export const cycleText = (language: Language, cycle: number): CycleText => texts(language).cycles.of[cycle as CycleNumber];

/** The manual's step that a move belongs to, as a status line: "Step 3 of 6: retract by the infeed". */
export function stepSentence(language: Language, cycle: number, run: "rough" | "finish", step: number): string {
  const { cycles } = texts(language);
  const steps = cycleText(language, cycle)[run];
  const text = steps[step - 1];
  if (text === undefined) return cycles.positioning;
  return run === "rough" ? cycles.roughStep(step, steps.length, text) : cycles.finishStep(step, steps.length, text);
}
