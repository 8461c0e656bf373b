import { menuWordsOf } from "virtual:cycle-menu";
import { useEffect, useState } from "react";
import { LANGUAGES } from "../../../i18n/languages.ts";
import type { MenuWords } from "../../../i18n/menu-words.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { takeAnswer } from "../../base/until-gone.ts";

/** Words to search: the screen language, and the other languages once a search starts. */
export function useMenuWords(searching: boolean): readonly MenuWords[] {
  const { menu } = useTexts("first");
  const [others, take] = useState<readonly MenuWords[]>([]);
  useEffect(() => {
    if (!searching) return undefined;
    return takeAnswer(() => Promise.all(LANGUAGES.map(menuWordsOf)).catch(() => []), take);
  }, [searching]);
  return others.length > 0 ? others : [menu];
}
