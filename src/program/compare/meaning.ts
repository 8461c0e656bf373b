import { klartext } from "../../nc/blocks/klartext.ts";
import { BARE, ComparedWords } from "../../nc/blocks/compared-words.ts";
import { statementLines } from "../../nc/print.ts";
import type { Block } from "../../nc/program.ts";

/** Meaning of a block, independent of its spelling. */
export interface Meaning {
  /** Its kind: only blocks of one kind are compared. */
  readonly kind: string;
  /** The kind with its cycle, label, axes or target. */
  readonly like: string;
  /** Each word with its normalized value; unnamed ones are under "". */
  readonly words: ReadonlyMap<string, string>;
  /** Equal exactly for blocks with the same meaning. */
  readonly key: string;
}

/** Whether a block has a meaning for the control. */
export const isSaid = ({ statement: { kind } }: Block): boolean =>
  kind !== "empty" && kind !== "comment" && kind !== "structure";

/** Text of a block without its number, its comment and its line ends. */
export const bareText = ({ raw, number, skip }: Pick<Block, "raw" | "number" | "skip">): string =>
  raw
    .replace(skip || number !== null ? /^\s*\/?[ \t]*(?:N?\d+(?![\d.,]))?[ \t]*\/?/i : /^\s*/, "")
    .replace(/[^\r\n]+/g, (line) => {
      const from = line.indexOf(";", line.lastIndexOf('"') + 1);
      return from < 0 ? line : line.slice(0, from);
    });

/**
 * Normalized meaning of a block: case, blanks, word order, names of cycles and labels of their parameters do not count.
 */
export function meaningOf(block: Block): Meaning {
  const { statement: s, raw, skip, issues } = block;
  const { pairKey: kind, nameKey, comparedWords: spoken } = klartext.compared(s, raw);
  // A block that is not fully understood is compared as text.
  const said =
    issues && s.kind !== "cycle"
      ? new ComparedWords().text("", bareText(block))
      : (spoken ?? new ComparedWords().text("", statementLines(s, BARE).join(" ")));
  if (skip) said.put("/", "/");
  const words = new Map([...said.words].sort(([a], [b]) => (a < b ? -1 : 1)));
  return { kind, like: nameKey, words, key: JSON.stringify([kind, nameKey, ...[...words].flat()]) };
}

/** One changed word; null where one of the blocks lacks it. */
export interface WordChange {
  /** X, F, Q463; "" for an unnamed value. */
  readonly name: string;
  readonly from: string | null;
  readonly to: string | null;
}

/** Changed words between two blocks, sorted by name. */
export function wordChanges(a: Meaning, b: Meaning): readonly WordChange[] {
  const names = [...new Set([...a.words.keys(), ...b.words.keys()])];
  return names
    .flatMap((name) => {
      const [from, to] = [a.words.get(name) ?? null, b.words.get(name) ?? null];
      return from === to ? [] : [{ name, from, to }];
    })
    .sort((one, other) => one.name.localeCompare(other.name, "en", { numeric: true }));
}
