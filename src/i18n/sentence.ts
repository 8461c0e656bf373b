import type { Kind } from "../cycles/params.ts";
import type { Texts } from "./index.ts";
import type { Spoken } from "./lengths.ts";
import type { AnyIssue } from "./message-texts.ts";
import { writer, type Write } from "./write.ts";

/** Words of an approach with a range, by their quantity. */
const OF_APPROACH: Readonly<Partial<Record<string, Kind>>> = { LEN: "length", R: "length", CCA: "angle" };

/** The quantity of a finding's value: that of its parameter, or of a word of its block. */
export function measureOf({ code, at }: AnyIssue, kind?: Kind): Kind | undefined {
  return kind ?? (code === "outOfRange" && at !== undefined ? OF_APPROACH[at] : undefined);
}

/** The sentence of a finding in loaded texts. A finding with several places names the first and counts the others. */
export function messageIn(inTexts: Pick<Texts, "messages">, spoken: Spoken, found: AnyIssue, kind?: Kind): string {
  const write = writer(spoken, measureOf(found, kind));
  const more = "places" in found.data && typeof found.data.places === "number" ? found.data.places - 1 : 0;
  const place = (x: number, z: number) => inTexts.messages.morePlaces(write.place(x, z), more);
  return sentenceOf(inTexts, found, more > 0 ? { ...write, place } : write);
}

/** The sentence of a finding, with numbers formatted by a writer. */
export function sentenceOf({ messages }: Pick<Texts, "messages">, found: AnyIssue, write: Write): string {
  const sentence = messages.of[found.code] as (data: object, write: Write) => string;
  return sentence(found.data, write);
}
