import type { Kind } from "../cycles/params.ts";
import { texts } from "./index.ts";
import type { Language } from "./languages.ts";
import type { AnyIssue } from "./message-texts.ts";
import { writer, type Write } from "./write.ts";

/** The sentence of a finding; `kind` is what its field measures, so that a diameter is written with its sign. */
export function message(language: Language, found: AnyIssue, kind?: Kind): string {
  const sentence = texts(language).messages.of[found.code] as (data: object, write: Write) => string;
  return sentence(found.data, writer(language, kind));
}
