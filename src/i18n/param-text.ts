import type { ChoiceTextId, ParamTextId } from "../cycles/index.ts";

/** What the screen says about one parameter. */
export interface ParamText {
  /** The question as the control asks it. */
  readonly prompt: string;
  /** True when this prompt is printed in a manual page of this language; false where we word it ourselves. */
  readonly printed: boolean;
  /** A few words for an answered prompt and in front of a message. */
  readonly label: string;
  /** What the value does, in one to three sentences. */
  readonly explanation: string;
}

/** A choice also says what each of its numbers means. */
export interface ChoiceText extends ParamText {
  readonly choices: Readonly<Record<number, string>>;
}

/** A parameter of the catalogue without its texts is a compile error in each language. */
export type ParamsTexts = { readonly [T in ParamTextId]: T extends ChoiceTextId ? ChoiceText : ParamText };

/** Texts of some of them: what one group of cycles has for itself. */
export type SomeParamTexts = Partial<ParamsTexts>;
