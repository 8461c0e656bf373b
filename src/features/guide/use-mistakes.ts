import type { ParamTextId } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { loadMistakes } from "../../i18n/load-mistakes.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

const { useThem } = laterTexts(loadMistakes);

/** What is often done wrong with a parameter: with it in particular first, then with values of its kind. */
export function useMistakes({ text, kind }: Pick<Param, "text" | "kind">): readonly string[] {
  const { of, kinds } = useThem();
  return [...(of[text as ParamTextId] ?? []), ...kinds[kind]];
}
