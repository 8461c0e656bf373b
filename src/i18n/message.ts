import type { Kind } from "../cycles/params.ts";
import { texts } from "./index.ts";
import type { Language } from "./languages.ts";
import type { Spoken } from "./lengths.ts";
import type { AnyIssue } from "./message-texts.ts";
import { messageIn, sentenceOf } from "./sentence.ts";
import type { Write } from "./write.ts";

/** The sentence of a finding; `kind` is the quantity of its field, so that a diameter gets its sign. */
export const message = (spoken: Spoken, found: AnyIssue, kind?: Kind): string =>
  messageIn(texts(typeof spoken === "string" ? spoken : spoken.language), spoken, found, kind);

/** The sentence of a finding, with numbers formatted by a writer. */
export const messageWith = (language: Language, found: AnyIssue, write: Write): string =>
  sentenceOf(texts(language), found, write);
