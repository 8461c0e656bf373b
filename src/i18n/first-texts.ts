import type { ChooserTexts } from "./en/chooser.ts";
import type { PageTexts } from "./en/page.ts";
import type { Language } from "./languages.ts";
import type { MenuWords } from "./menu-words.ts";

/** What the first screen says: it waits for no other text. */
export interface FirstTexts {
  readonly page: PageTexts;
  readonly chooser: ChooserTexts;
  /** Names of the cycles. */
  readonly menu: MenuWords;
}

/** The part of them that is written down as it stands; the names are taken out of the texts of the cycles. */
export type WrittenFirst = Omit<FirstTexts, "menu">;

/** Fetches that part in one language. */
export async function loadFirst(language: Language): Promise<WrittenFirst> {
  switch (language) {
    case "en":
      return (await import("./en/first.ts")).first;
    case "de":
      return (await import("./de/first.ts")).first;
    case "fr":
      return (await import("./fr/first.ts")).first;
    case "zh":
      return (await import("./zh/first.ts")).first;
  }
}
