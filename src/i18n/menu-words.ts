import type { Group } from "../cycles/define.ts";
import { texts } from "./index.ts";
import { ncLanguageOf, type Language } from "./languages.ts";
import { ncLabels } from "./nc-labels.ts";
import type { ShopWords } from "./shop-words.ts";

const shop = import.meta.glob<ShopWords>("./*/first/shop-words.ts", { eager: true, import: "shopWords" });

/** The menu texts of one cycle. */
export interface MenuWord {
  readonly name: string;
  readonly summary: string;
  /** The name that the control writes after the number. */
  readonly nc: string;
}

/** Names of groups and cycles in one language, without the texts of dialogs. */
export interface MenuWords {
  readonly groups: Readonly<Record<Group, string>>;
  readonly of: Readonly<Record<number, MenuWord>>;
  /** Names of the cycles that a program preserves and that are not simulated. */
  readonly kept: Readonly<Record<number, string>>;
  readonly shop: ShopWords;
}

/** Extracts the menu texts from all texts. The build does this, so that the first screen loads no other texts. */
export function menuWords(language: Language): MenuWords {
  const { groups, of, kept } = texts(language).cycles;
  const { cycleName } = ncLabels(ncLanguageOf(language));
  const words = Object.entries(of).map(
    ([number, { name, summary }]) => [Number(number), { name, summary, nc: cycleName(Number(number)) }] as const,
  );
  return { groups, of: Object.fromEntries(words), kept, shop: shop[`./${language}/first/shop-words.ts`] as ShopWords };
}
