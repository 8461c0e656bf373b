import type { Kind } from "../cycles/params.ts";
import { texts, type Texts } from "./index.ts";
import type { Spoken } from "./lengths.ts";
import type { AnyIssue } from "./message-texts.ts";
import { writer, type Write } from "./write.ts";

/** The sentence of a finding; `kind` is what its field measures, so that a diameter is written with its sign. */
export const message = (spoken: Spoken, found: AnyIssue, kind?: Kind): string =>
  messageIn(texts(typeof spoken === "string" ? spoken : spoken.language), spoken, found, kind);

/** The same in texts that are at hand. A finding that was met in several places names the first of them and counts the others. */
export function messageIn({ messages }: Pick<Texts, "messages">, spoken: Spoken, found: AnyIssue, kind?: Kind): string {
  const sentence = messages.of[found.code] as (data: object, write: Write) => string;
  const write = writer(spoken, kind);
  const more = "places" in found.data && typeof found.data.places === "number" ? found.data.places - 1 : 0;
  return sentence(found.data, more > 0 ? { ...write, place: (x, z) => messages.morePlaces(write.place(x, z), more) } : write);
}
