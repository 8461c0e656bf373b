import type { MenuWords } from "../../../i18n/menu-words.ts";
import type { UnofferedCycle, MenuCycle } from "./menu.ts";

/** Lower case without accents, since text typed at a machine has neither. */
export const withoutAccents = (text: string): string =>
  text
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replaceAll("ß", "ss")
    .replaceAll("œ", "oe")
    .replaceAll("’", "'");

/** How well a cycle matches a word; 0 is best. */
type Rank = 0 | 1 | 2 | 3;

/** Fewest letters for which synonyms are searched. */
const ENOUGH = 3;
const isCjk = (word: string) => /\p{Script=Han}/u.test(word);

/** The word, and the synonyms of any word that it begins. */
function withSynonyms(word: string, languages: readonly MenuWords[]): readonly string[] {
  const enough = isCjk(word) || word.length >= ENOUGH;
  const same = languages.flatMap(({ shop }) => shop.same.map((words) => words.map(withoutAccents)));
  return [word, ...(enough ? same.filter((words) => words.some((each) => each.startsWith(word))).flat() : [])];
}

/** A typed word with its synonyms. */
interface SearchWord {
  readonly word: string;
  readonly words: readonly string[];
}

function rankOf(cycle: MenuCycle, { word, words }: SearchWord, languages: readonly MenuWords[]): Rank | null {
  if (/^\d+$/.test(word)) return String(cycle.number).startsWith(word) ? 0 : null;
  const within = (texts: readonly string[]) =>
    texts.some((text) => words.some((each) => withoutAccents(text).includes(each)));
  const of = languages.flatMap((language) => language.of[cycle.number] ?? []);
  if (within(of.map(({ name }) => name))) return 1;
  if (
    within(
      languages.flatMap(({ shop, groups }) => [
        groups[cycle.group],
        ...shop.groups[cycle.group],
        ...(cycle.free ? shop.free : []),
      ]),
    )
  )
    return 2;
  return within(of.flatMap(({ summary, nc }) => [summary, nc])) ? 3 : null;
}

/** Search words, normalised. A DIN/ISO G number becomes the cycle number. */
const wordsOf = (typed: string): readonly string[] =>
  withoutAccents(typed)
    .split(/[\s,;]+/)
    .filter((word) => word !== "")
    .map((word) => word.replace(/^g(?=\d)/, ""));

/** Whether the number or name of a cycle matches all typed words, in any of these languages. */
export function isNamed(number: number, typed: string, languages: readonly MenuWords[]): boolean {
  const names = languages.map(({ of, kept }) => withoutAccents(of[number]?.name ?? kept[number] ?? ""));
  return wordsOf(typed).every((word) =>
    /^\d+$/.test(word) ? String(number).startsWith(word) : names.some((name) => name.includes(word)),
  );
}

/** Cycles whose number or name matches all typed words, in any of these languages. */
export const findUnoffered = (
  cycles: readonly UnofferedCycle[],
  typed: string,
  languages: readonly MenuWords[],
): readonly UnofferedCycle[] => cycles.filter(({ number }) => isNamed(number, typed, languages));

/** Cycles that match all typed words in any of these languages, best first. */
export function findCycles(
  menu: readonly MenuCycle[],
  typed: string,
  languages: readonly MenuWords[],
): readonly MenuCycle[] {
  const sought = wordsOf(typed).map((word) => ({ word, words: withSynonyms(word, languages) }));
  const ranked = menu.flatMap((cycle) => {
    const ranks = sought.map((each) => rankOf(cycle, each, languages));
    return ranks.some((rank) => rank === null) ? [] : [{ cycle, rank: Math.max(...ranks.map(Number)) }];
  });
  return ranked.sort((a, b) => a.rank - b.rank).map(({ cycle }) => cycle);
}
