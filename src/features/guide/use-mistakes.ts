import type { ParamTextId } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Common mistakes with a parameter: its own first, then those of its kind of value. */
export function useMistakes({ text, kind }: Pick<Param, "text" | "kind">): readonly string[] {
  const { of, kinds } = useTexts("mistakes");
  return [...(of[text as ParamTextId] ?? []), ...kinds[kind]];
}
