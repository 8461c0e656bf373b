import type { ParamTextId } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** What is often done wrong with a parameter: with it in particular first, then with values of its kind. */
export function useMistakes({ text, kind }: Pick<Param, "text" | "kind">): readonly string[] {
  const { of, kinds } = useTexts("mistakes");
  return [...(of[text as ParamTextId] ?? []), ...kinds[kind]];
}
