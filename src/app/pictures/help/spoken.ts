import type { ParamTextId } from "../../../cycles/index.ts";
import type { Params } from "../../../cycles/params.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { lengthsIn } from "../../../i18n/lengths.ts";
import { INCH } from "../../../kernel/units.ts";
import type { DraftInches } from "../../../program/job/read-draft.ts";
import type { Numbers } from "../../../view/help/lettering.ts";
import { numberIn } from "./number-in.ts";

/** What the picture shows, and how its numbers are written. */
interface Pictured {
  readonly params: Params;
  readonly values: Numbers;
  readonly inches: DraftInches | null;
}

/** A value and its dimension in words: "diameter 75 mm", "1, chamfer". */
export function valueInWords(
  texts: Texts,
  language: Language,
  { params, values, inches }: Pictured,
  q: string,
): string {
  const param = params[q],
    value = values[q],
    say = texts.help.inWords;
  if (!param || value === undefined) return texts.help.noValue;
  if (value === "auto") return say.auto;
  const number = numberIn(language, inches)(value, param.decimals, param);
  if (param.kind !== "choice") {
    const words = say[param.kind](number);
    return inches ? lengthsIn(language, "inch", INCH).words(words) : words;
  }
  const words = texts.params[param.text as ParamTextId];
  return say.choice(number, ("choices" in words ? words.choices[value] : undefined) ?? "");
}

/** Text alternative of the picture. */
export function pictureInWords(
  texts: Texts,
  language: Language,
  cycle: { readonly number: number; readonly params: Params },
  q: string | null,
  values: Numbers,
  inches: DraftInches | null,
): string {
  const name = texts.help.picture(String(cycle.number));
  const param = q === null ? undefined : cycle.params[q];
  if (q === null || !param) return name;
  const label = texts.params[param.text as ParamTextId].label;
  return `${name}. ${texts.help.highlighted(q, label, valueInWords(texts, language, { params: cycle.params, values, inches }, q))}.`;
}
