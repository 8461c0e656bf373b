import { klartext } from "../../nc/blocks/klartext.ts";
import { BARE, Said } from "../../nc/blocks/said.ts";
import { statementLines } from "../../nc/print.ts";
import type { Block } from "../../nc/program.ts";

/** What a block says, apart from how it is written. */
export interface Meaning {
  /** What it is: only blocks of one kind are ever set against each other. */
  readonly kind: string;
  /** The same with what names it: cycle, label, axes, target. */
  readonly like: string;
  /** Each word with its value in one spelling; what has no name of its own stands under "". */
  readonly words: ReadonlyMap<string, string>;
  /** The same for two blocks exactly when they mean the same. */
  readonly key: string;
}

/** Blocks that say nothing to the control. */
export const isSaid = ({ statement: { kind } }: Block): boolean =>
  kind !== "empty" && kind !== "comment" && kind !== "structure";

/** A block as it stands, without its number, its comment and its line ends. */
export const bareText = ({ raw, number, skip }: Pick<Block, "raw" | "number" | "skip">): string =>
  raw
    .replace(skip || number !== null ? /^\s*\/?[ \t]*(?:N?\d+(?![\d.,]))?[ \t]*\/?/i : /^\s*/, "")
    .replace(/;[^\r\n"]*(?=[\r\n]|$)/g, "");

/**
 * What a block says, in one spelling: case, blanks, order of words, names of cycles and labels of their parameters do
 * not count.
 */
export function meaningOf(block: Block): Meaning {
  const { statement: s, raw, skip, issues } = block;
  const { pairs: kind, like, said: spoken } = klartext.compared(s, raw);
  // What the reader did not wholly take up is compared as it stands.
  const said =
    issues.length > 0 && s.kind !== "cycle"
      ? new Said().text("", bareText(block))
      : (spoken ?? new Said().text("", statementLines(s, BARE).join(" ")));
  if (skip) said.put("/", "/");
  const words = new Map([...said.words].sort(([a], [b]) => (a < b ? -1 : 1)));
  return { kind, like, words, key: JSON.stringify([kind, like, ...[...words].flat()]) };
}

/** One word of a block and what became of it; null where one of the two has no such word. */
export interface WordChange {
  /** X, F, Q463; "" for what has no name. */
  readonly name: string;
  readonly from: string | null;
  readonly to: string | null;
}

/** What differs between two blocks, word by word, in the order of their names. */
export function wordChanges(a: Meaning, b: Meaning): readonly WordChange[] {
  const names = [...new Set([...a.words.keys(), ...b.words.keys()])];
  return names
    .flatMap((name) => {
      const [from, to] = [a.words.get(name) ?? null, b.words.get(name) ?? null];
      return from === to ? [] : [{ name, from, to }];
    })
    .sort((one, other) => one.name.localeCompare(other.name, "en", { numeric: true }));
}
