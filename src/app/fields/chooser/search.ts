import type { MenuWords } from "../../../i18n/menu-words.ts";
import type { Elsewhere, MenuCycle } from "./menu.ts";

/** Letters without accents and case: what is typed at a machine has neither. */
export const plain = (text: string): string =>
  text
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replaceAll("ß", "ss")
    .replaceAll("œ", "oe")
    .replaceAll("’", "'");

/** How well a cycle fits a word, best first; null where it does not. */
type Rank = 0 | 1 | 2 | 3;

/** Shorter beginnings say too little to stand for the other words of the same thing. */
const ENOUGH = 3;
const isCjk = (word: string) => /\p{Script=Han}/u.test(word);

/** The word, and all words for the same thing where it is the beginning of one. */
function meant(word: string, languages: readonly MenuWords[]): readonly string[] {
  const enough = isCjk(word) || word.length >= ENOUGH;
  const same = languages.flatMap(({ shop }) => shop.same.map((words) => words.map(plain)));
  return [word, ...(enough ? same.filter((words) => words.some((each) => each.startsWith(word))).flat() : [])];
}

/** A word that was typed, and what it stands for. */
interface Sought {
  readonly word: string;
  readonly words: readonly string[];
}

function rankOf(cycle: MenuCycle, { word, words }: Sought, languages: readonly MenuWords[]): Rank | null {
  if (/^\d+$/.test(word)) return String(cycle.number).startsWith(word) ? 0 : null;
  const within = (texts: readonly string[]) => texts.some((text) => words.some((each) => plain(text).includes(each)));
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

/** Words as they are compared; the G number by which DIN/ISO calls a cycle is its number. */
const wordsOf = (typed: string): readonly string[] =>
  plain(typed)
    .split(/[\s,;]+/)
    .filter((word) => word !== "")
    .map((word) => word.replace(/^g(?=\d)/, ""));

/** Those that fit everything that was typed by their number or name, in any of these languages. */
export function findElsewhere(
  cycles: readonly Elsewhere[],
  typed: string,
  languages: readonly MenuWords[],
): readonly Elsewhere[] {
  const sought = wordsOf(typed);
  return cycles.filter(({ number }) => {
    const names = languages.map(({ of, kept }) => plain(of[number]?.name ?? kept[number] ?? ""));
    return sought.every((word) =>
      /^\d+$/.test(word) ? String(number).startsWith(word) : names.some((name) => name.includes(word)),
    );
  });
}

/** The cycles that fit everything that was typed, the best first, in any of these languages. */
export function findCycles(
  menu: readonly MenuCycle[],
  typed: string,
  languages: readonly MenuWords[],
): readonly MenuCycle[] {
  const sought = wordsOf(typed).map((word) => ({ word, words: meant(word, languages) }));
  const ranked = menu.flatMap((cycle) => {
    const ranks = sought.map((each) => rankOf(cycle, each, languages));
    return ranks.some((rank) => rank === null) ? [] : [{ cycle, rank: Math.max(...ranks.map(Number)) }];
  });
  return ranked.sort((a, b) => a.rank - b.rank).map(({ cycle }) => cycle);
}
