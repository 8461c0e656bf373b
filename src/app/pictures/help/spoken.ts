import type { ParamTextId } from "../../../cycles/index.ts";
import type { Params } from "../../../cycles/params.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { Numbers } from "../../../view/help/lettering.ts";

/** A value and its dimension in words: "diameter 75 mm", "1, chamfer". */
export function valueInWords(texts: Texts, language: Language, params: Params, q: string, values: Numbers): string {
  const param = params[q],
    value = values[q],
    say = texts.help.inWords;
  if (!param || value === undefined) return texts.help.noValue;
  if (value === "auto") return say.auto;
  const number = formatNumber(language, value, param.decimals);
  if (param.kind !== "choice") return say[param.kind](number);
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
): string {
  const name = texts.help.picture(String(cycle.number));
  const param = q === null ? undefined : cycle.params[q];
  if (q === null || !param) return name;
  const label = texts.params[param.text as ParamTextId].label;
  return `${name}. ${texts.help.highlighted(q, label, valueInWords(texts, language, cycle.params, q, values))}.`;
}
