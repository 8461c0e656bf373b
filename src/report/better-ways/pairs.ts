import { parse } from "../../nc/parse.ts";
import { print, type Block, type Program } from "../../nc/program.ts";
import { withBlocks } from "../../nc/replace.ts";
import type { BetterWay, Candidate } from "./way.ts";

/** Most ways of which every two are tried together, the best ones. */
const MOST = 4;

/** Blocks that take the place of those from `from` to `to`. */
interface Hunk {
  readonly from: number;
  readonly to: number;
  readonly blocks: readonly Block[];
}

/** The blocks between the first and the last difference of two programs; block numbers are none. */
function hunkOf(before: readonly Block[], now: readonly Block[], textOf: (block: Block) => string): Hunk {
  const isSame = (i: number, k: number) => {
    const [a, b] = [before[i], now[k]];
    return a !== undefined && b !== undefined && textOf(a) === textOf(b);
  };
  let front = 0;
  while (isSame(front, front)) front += 1;
  let behind = 0;
  const least = Math.min(before.length, now.length) - front;
  while (behind < least && isSame(before.length - 1 - behind, now.length - 1 - behind)) behind += 1;
  return { from: front, to: before.length - behind, blocks: now.slice(front, now.length - behind) };
}

/** A block without its number. */
const bare = ({ raw, number }: Block): string =>
  number === null ? raw.trimEnd() : raw.replace(/^[ \t]*(?:\/[ \t]*)?N?\d+/i, "").trimEnd();

/** The program with two of its changes; null where they concern the same blocks. */
function merged(program: Program, a: Program, b: Program): Program | null {
  const { blocks } = program;
  const [first, second] = [a, b]
    .map((each) => hunkOf(blocks, each.blocks, bare))
    .toSorted((x, y) => x.from - y.from || x.to - y.to);
  if (!first || !second || first.to > second.from) return null;
  return withBlocks(program, [
    ...blocks.slice(0, first.from),
    ...first.blocks,
    ...blocks.slice(first.to, second.from),
    ...second.blocks,
    ...blocks.slice(second.to),
  ]);
}

/** Every two of the best ways of a program made together, where they change different operations. */
export function pairsOf(text: string, ways: readonly BetterWay[]): readonly Candidate[] {
  const best = ways
    .filter(({ subject }) => subject.kind !== "both")
    .toSorted((a, b) => b.worth - a.worth)
    .slice(0, MOST);
  const program = parse(text);
  return best.flatMap((a, i) =>
    best.slice(i + 1).flatMap((b): readonly Candidate[] => {
      if (a.subject.units.some((unit) => b.subject.units.includes(unit))) return [];
      const both = merged(program, parse(a.text), parse(b.text));
      const units = [...a.subject.units, ...b.subject.units];
      return both ? [{ subject: { kind: "both", units, parts: [a.subject, b.subject] }, text: print(both) }] : [];
    }),
  );
}
