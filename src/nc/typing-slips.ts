import { blocks } from "./blocks/index.ts";
import { klartext } from "./blocks/klartext.ts";
import type { NcCode, NcFix, NcIssue } from "./issue.ts";
import { parse } from "./parse.ts";

/** Smallest number of typed, missing, wrong or exchanged letters between two words; `most + 1` for any more. */
export function lettersApart(a: string, b: string, most: number): number {
  if (Math.abs(a.length - b.length) > most) return most + 1;
  let [before, last]: [readonly number[], readonly number[]] = [[], Array.from({ length: b.length + 1 }, (_, j) => j)];
  for (let i = 1; i <= a.length; i += 1) {
    const row = [i];
    for (let j = 1; j <= b.length; j += 1) {
      const swap = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      row.push(
        Math.min(
          (last[j] ?? 0) + 1,
          (row[j - 1] ?? 0) + 1,
          (last[j - 1] ?? 0) + Number(a[i - 1] !== b[j - 1]),
          swap ? (before[j - 2] ?? 0) + 1 : Infinity,
        ),
      );
    }
    [before, last] = [last, row];
  }
  return Math.min(last[b.length] ?? 0, most + 1);
}

/** Shorter words differ from too many others. */
const SHORTEST = 3;
/** Letters that may be wrong in a word of this length. */
const mostWrong = (length: number): number => (length < 6 ? 1 : 2);

/** The beginnings of blocks, and the words that may follow them. */
interface Vocabulary {
  readonly beginnings: readonly string[];
  readonly words: ReadonlySet<string>;
}

function declaredWords(): Vocabulary {
  const beginnings = blocks.flatMap((block) => ("keyword" in block ? block.keyword : [])) as readonly string[];
  const following = klartext.named.flatMap(([, { offered }]) =>
    (offered?.begins && typeof offered.begins !== "function" ? klartext.fields(offered.begins) : []).flatMap(
      (field) => [
        field.letter ?? "",
        ...("choices" in field ? field.choices : []),
        ...(field.entry === "feed" ? ["FMAX", "FAUTO"] : []),
      ],
    ),
  );
  const isWord = (text: string) => text.length >= SHORTEST && /^[A-Z_]+$/.test(text);
  return {
    beginnings: beginnings.filter((each) => each.length >= SHORTEST),
    words: new Set([...beginnings.flatMap((each) => each.split(" ")), ...following].filter(isWord)),
  };
}

let vocabulary: Vocabulary | null = null;

interface Candidate {
  readonly text: string;
  readonly apart: number;
}

/** Texts with the beginning of another block, or with one other word, nearest first. */
function candidates(text: string): readonly Candidate[] {
  const { beginnings, words } = (vocabulary ??= declaredWords());
  const found: Candidate[] = [];
  const upper = text.toUpperCase();
  for (const begin of beginnings) {
    const most = mostWrong(begin.length);
    for (let length = begin.length - most; length <= begin.length + most; length += 1) {
      const rest = text.slice(length);
      if (length > text.length || /^[A-Z]/i.test(rest)) continue;
      const apart = lettersApart(upper.slice(0, length), begin, most);
      if (apart > 0 && apart <= most) found.push({ text: `${begin}${/^\d/.test(rest) ? " " : ""}${rest}`, apart });
    }
  }
  for (const { 0: typed, index } of upper.matchAll(/[A-Z_]{3,}/g)) {
    if (words.has(typed)) continue;
    for (const word of words) {
      const apart = lettersApart(typed, word, mostWrong(word.length));
      if (apart > mostWrong(word.length)) continue;
      found.push({ text: text.slice(0, index) + word + text.slice(index + typed.length), apart });
    }
  }
  return found.toSorted((a, b) => a.apart - b.apart);
}

const UNREAD: ReadonlySet<NcCode> = new Set<NcCode>(["notUnderstood", "wordNotUnderstood", "wordMissing", "badNumber"]);

/** A longer text is no word with a slip, and every word of it would be tried; a block with it is read again for each try. */
const LONGEST = { text: 200, block: 20_000 } as const;
/** Most corrections tried in a block that has two slips. */
const MOST = 6;

function correctedText(typed: string, isRead: (text: string) => boolean): string | null {
  const first = candidates(typed);
  const one = first.find(({ text }) => isRead(text));
  if (one) return one.text;
  for (const { text } of first.slice(0, MOST)) {
    const two = candidates(text).find((each) => isRead(each.text));
    if (two) return two.text;
  }
  return null;
}

/**
 * The correction of a block or word that is not understood, where another spelling of a word makes the whole block
 * readable; null without one. `raw`: the text of the block, which begins at `begin`.
 */
export function spellingFix({ code, offset, length }: NcIssue, raw: string, begin: number): NcFix | null {
  if (code !== "notUnderstood" && code !== "wordNotUnderstood") return null;
  if (length > LONGEST.text || raw.length > LONGEST.block) return null;
  const [from, to] = [offset - begin, offset - begin + length];
  const text = correctedText(raw.slice(from, to), (spelt) => {
    const read = parse(raw.slice(0, from) + spelt + raw.slice(to)).blocks;
    return read.length === 1 && !read[0]?.issues?.some((each) => UNREAD.has(each.code));
  });
  return text === null ? null : { offset, length, text };
}
