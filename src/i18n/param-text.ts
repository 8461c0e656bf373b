import type { ChoiceTextId, ParamTextId } from "../cycles/index.ts";

/** The screen texts of one parameter. */
export interface ParamText {
  /** The question as the control asks it. */
  readonly prompt: string;
  /** True when a manual page of this language prints this prompt; false where we word it ourselves. */
  readonly printed: boolean;
  /** A few words for an answered prompt and before a message. */
  readonly label: string;
  /** The effect of the value, in one to three sentences. */
  readonly explanation: string;
}

/** A choice also explains each of its numbers. */
export interface ChoiceText extends ParamText {
  readonly choices: Readonly<Record<number, string>>;
}

/** A parameter of the catalogue without its texts is a compile error in each language. */
export type ParamsTexts = { readonly [T in ParamTextId]: T extends ChoiceTextId ? ChoiceText : ParamText };

/** Texts of some parameters: those of one group of cycles. */
export type SomeParamTexts = Partial<ParamsTexts>;
