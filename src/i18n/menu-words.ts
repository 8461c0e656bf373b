import type { Group } from "../cycles/define.ts";
import { texts } from "./index.ts";
import { ncLanguageOf, type Language } from "./languages.ts";
import { ncLabels } from "./nc-labels.ts";
import type { ShopWords } from "./shop-words.ts";

const shop = import.meta.glob<ShopWords>("./*/first/shop-words.ts", { eager: true, import: "shopWords" });

/** What the menu says about one cycle. */
export interface MenuWord {
  readonly name: string;
  readonly summary: string;
  /** What the control writes behind its number. */
  readonly nc: string;
}

/** Names of groups and cycles in one language, without what only their dialogs say. */
export interface MenuWords {
  readonly groups: Readonly<Record<Group, string>>;
  readonly of: Readonly<Record<number, MenuWord>>;
  /** Names of the cycles that a program keeps and that are not run. */
  readonly kept: Readonly<Record<number, string>>;
  readonly shop: ShopWords;
}

/**
 * Takes the words of the menu out of all texts. The build does that, so that the first screen loads nothing else of
 * them.
 */
export function menuWords(language: Language): MenuWords {
  const { groups, of, kept } = texts(language).cycles;
  const { cycleName } = ncLabels(ncLanguageOf(language));
  const words = Object.entries(of).map(
    ([number, { name, summary }]) => [Number(number), { name, summary, nc: cycleName(Number(number)) }] as const,
  );
  return { groups, of: Object.fromEntries(words), kept, shop: shop[`./${language}/first/shop-words.ts`] as ShopWords };
}
