import type { Kind } from "../cycles/params.ts";
import { texts } from "./index.ts";
import type { Spoken } from "./lengths.ts";
import type { AnyIssue } from "./message-texts.ts";
import { writer, type Write } from "./write.ts";

/** The sentence of a finding; `kind` is what its field measures, so that a diameter is written with its sign. */
export function message(spoken: Spoken, found: AnyIssue, kind?: Kind): string {
  const sentence = texts(typeof spoken === "string" ? spoken : spoken.language).messages.of[found.code] as (
    data: object,
    write: Write,
  ) => string;
  return sentence(found.data, writer(spoken, kind));
}
