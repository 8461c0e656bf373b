import type { GuideBlocksTexts } from "../../i18n/en/guide-blocks.ts";
import type { GuidePlacesTexts } from "../../i18n/en/guide-places.ts";
import { wordOfField } from "../../app/fields/blocks/block-guide.ts";
import type { FieldFacts } from "../../nc/blocks/define.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import type { SetupPageId } from "./setup-variants.ts";

/** Texts about a word of a block. */
export interface WordTexts {
  readonly about: string;
  readonly mistakes: readonly string[];
}

const entry = <T>(of: Readonly<Record<string, T>>, key: string): T | null =>
  Object.hasOwn(of, key) ? (of[key] ?? null) : null;

/** Texts about a word in a kind of block; null if there are none. `places`: texts of the set-up pages, if loaded. */
export function blockWordTexts(
  t: GuideBlocksTexts,
  kind: BlockKind,
  field: FieldFacts,
  places?: GuidePlacesTexts,
): WordTexts | null {
  const { setup, about = "" } = field;
  if (setup !== undefined) return places?.places[setup as SetupPageId] ?? { about: "", mistakes: [] };
  const word = wordOfField(field);
  return entry(t.of, `${kind}.${word}`) ?? entry(t.of, word) ?? entry(t.of, about);
}

/** The control's rule for a word; empty if it has none. */
export const blockRule = (t: GuideBlocksTexts, kind: BlockKind, word: string): string =>
  entry(t.rules, `${kind}.${word}`) ?? entry(t.rules, word) ?? "";
