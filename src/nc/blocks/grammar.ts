import type { BlockIssue } from "../issue.ts";
import { LONGEST_LINE } from "../longest-line.ts";
import type { BlockLine } from "../read-cycle.ts";
import { Scan } from "../scan.ts";
import type { Style } from "../style.ts";
import {
  within,
  type BlockDefinition,
  type Field,
  type LineField,
  type Named,
  type BlockReading,
  type Tag,
} from "./define.ts";
import { ComparedWords } from "./compared-words.ts";

/** A statement of any kind, as its declaration sees it. */
interface AnyStatement {
  readonly kind: string;
}
type Held = Record<string, unknown> & AnyStatement;

/** A statement for comparison: pairing keys and words; null words: compare as text. */
export interface Compared {
  readonly pairKey: string;
  readonly nameKey: string;
  readonly comparedWords: ComparedWords | null;
}

const keywordsOf = ({ keyword = [] }: BlockDefinition): readonly string[] =>
  typeof keyword === "string" ? [keyword] : keyword;

/** The pattern of a kind's beginning; null without a keyword. */
function beginningOf(block: BlockDefinition): string | null {
  if (block.begins !== undefined) return block.begins;
  const spelt = keywordsOf(block).map((each) => each.replaceAll(" ", String.raw`[ \t\u00a0]+`));
  return spelt.length === 0 ? null : `(?:${spelt.join("|")})(?![A-Z_])`;
}

/** Reads the words of a block: those without letters in order, then the others in any order. */
function byWords(block: BlockDefinition, reading: BlockReading): Held | null {
  const { scan } = reading;
  const s: Held = { kind: block.kind };
  const found: Readonly<Record<string, unknown>> = block.found?.(reading) ?? {};
  const missing = new Set(block.words.filter((word) => word.needed !== undefined));
  for (const word of block.words) {
    const taken = word.key in found ? found[word.key] : word.lettered ? undefined : word.take(scan);
    if (taken !== undefined && taken !== null) missing.delete(word);
    if (taken === undefined && !("absent" in word)) return null;
    s[word.key] = taken === undefined ? word.absent : taken;
  }
  const lettered = block.words.filter((word) => word.lettered);
  const keeper = block.words.find((word) => word.keep);
  while (!scan.done) {
    const next = lettered.find((word) => {
      const taken = word.take(scan);
      if (taken === undefined) return false;
      if (taken !== null) missing.delete(word);
      s[word.key] = taken;
      return true;
    });
    if (next) continue;
    if (!keeper) break;
    const text = scan.word();
    s[keeper.key] = keeper.keep?.(s[keeper.key], text);
    scan.unread(text);
  }
  scan.leftOver();
  for (const { needed } of missing) if (needed !== undefined) scan.missing(needed);
  return s;
}

/** The lines of one block as one text with unchanged positions, without comments. */
const joined = (lines: readonly BlockLine[]): string =>
  lines.reduce((text, line) => text.padEnd(line.offset - (lines[0]?.offset ?? 0)) + line.text, "");

/** The whole block as a text field, for blocks without single fields. */
const WHOLE: LineField<AnyStatement, "text"> = {
  id: "text",
  name: "text",
  wide: true,
  noPicture: "name",
  entry: "line",
  shown: (text) => text,
  line: (_, typed) => typed,
  keeps: false,
};

/** Reading, printing, fields and comparison of statements, derived from the declarations of a table of kinds. */
export function grammarOf<S extends AnyStatement = AnyStatement>(kinds: readonly BlockDefinition[]) {
  const byKind = new Map(kinds.map((block) => [block.kind, block]));
  const announced = kinds.flatMap((block) => {
    const source = beginningOf(block);
    return source === null ? [] : [{ block, source, pattern: new RegExp(source, "iy") }];
  });
  const beginning = new RegExp(announced.map(({ source }) => `(${source})`).join("|"), "iy");
  const wrapped = new RegExp(
    announced
      .filter(({ block }) => block.lines === "joined")
      .map(({ source }) => String.raw`^[ \t]*(?:${source})`)
      .join("|") || "(?!)",
    "i",
  );
  const blockOf = (s: AnyStatement): BlockDefinition => {
    const block = byKind.get(s.kind);
    if (!block) throw new Error(`no kind of block: ${s.kind}`);
    return block;
  };

  const readAs = (block: BlockDefinition, reading: BlockReading): Held | null =>
    block.read ? block.read(reading) : byWords(block, reading);

  /** Reads as the first kind with a matching beginning that succeeds. */
  function dispatch(scan: Scan, lines: readonly BlockLine[], issues: BlockIssue[]): Held | null {
    const m = scan.take(beginning);
    if (!m) return null;
    const from = scan.at - m[0].length;
    const first = m.findIndex((group, i) => i > 0 && group !== undefined) - 1;
    for (let i = first; i < announced.length; i += 1) {
      const kind = announced[i];
      if (!kind) break;
      const head = i === first ? m : scan.take(kind.pattern);
      const read = head && readAs(kind.block, { scan, head: head[0], lines, issues });
      if (read) return read;
      scan.back(from);
    }
    return null;
  }

  return {
    /** The statement of a block. A block that is not understood becomes `unknown` with one issue. */
    read(lines: readonly BlockLine[]): { readonly statement: S; readonly issues: readonly BlockIssue[] } {
      const made = (s: Held, issues: readonly BlockIssue[]) => ({ statement: s as AnyStatement as S, issues });
      const head = lines[0];
      if (!head) return made({ kind: "empty" }, []);
      const isWrapped = wrapped.test(head.text);
      const scan = new Scan(isWrapped ? joined(lines) : head.text, head.offset);
      if (scan.done && lines.length === 1)
        return made(head.comment === null ? { kind: "empty" } : { kind: "comment", text: head.comment }, []);
      const issues: BlockIssue[] = [];
      const statement = head.text.length > LONGEST_LINE ? null : dispatch(scan, lines, issues);
      if (!statement || (lines.length > 1 && !isWrapped && blockOf(statement).lines !== "own")) {
        const text = lines.map((l) => l.text.trim()).join(" ");
        const whole: BlockIssue = {
          code: "notUnderstood",
          severity: "info",
          offset: head.offset,
          length: head.text.trimEnd().length,
          data: { text: text.slice(0, 60) },
        };
        return made({ kind: "unknown", text }, [whole]);
      }
      for (const i of scan.issues) issues.push(i);
      return made(statement, issues);
    },

    /** The lines of a statement without block number and line ends. */
    lines(s: S, style: Style): readonly string[] {
      const block = blockOf(s);
      const held = s as AnyStatement as Held;
      const printed =
        block.print?.(held, style) ??
        (block.lead?.(held) ?? keywordsOf(block)[0] ?? "") +
          block.words.map((word) => word.text(held[word.key], style, held as never)).join("");
      return typeof printed === "string" ? [printed] : printed;
    },

    /** The fields of a form, in word order. */
    fields(s: S): readonly Field<S>[] {
      const block = blockOf(s);
      const held = s as AnyStatement as Held;
      const fields: readonly Field<Held>[] = block.isTypedAsText?.(held)
        ? [WHOLE]
        : (block.fields?.(held) ??
          block.words.flatMap((word) =>
            ((word.fields?.(held[word.key], held as never) ?? []) as readonly Field<unknown>[]).map((field) =>
              within(
                field,
                (of: Held) => of[word.key],
                (of, value): Held => ({ ...of, [word.key]: value }),
              ),
            ),
          ));
      return fields as readonly unknown[] as readonly Field<S>[];
    },

    /** The statement for comparison. `raw`: the text of the block. */
    compared(s: S, raw: string): Compared {
      const block = blockOf(s);
      const held = s as AnyStatement as Held;
      const pairKey = block.pairKey?.(held) ?? s.kind;
      const nameKey = block.nameKey?.(held) ?? s.kind;
      const comparedWords = new ComparedWords();
      if (block.compareAs) block.compareAs(held, comparedWords, raw);
      else if (block.words.some((word) => word.compareAs))
        for (const word of block.words) word.compareAs?.(held[word.key], comparedWords);
      else return { pairKey, nameKey, comparedWords: null };
      return { pairKey, nameKey, comparedWords };
    },

    /** The name of a statement. */
    nameOf: (s: S): string => blockOf(s).nameOf?.(s as AnyStatement as Held) ?? s.kind,
    blockOf: (s: S): BlockDefinition => blockOf(s),
    has: (s: S, tag: Tag): boolean => blockOf(s).tags?.includes(tag) ?? false,
    /** Every name of a kind with its own properties, in table order. */
    named: kinds.flatMap(
      (block): readonly (readonly [string, Named<S>])[] =>
        (block.names
          ? Object.entries(block.names)
          : [[block.kind, block]]) as readonly unknown[] as readonly (readonly [string, Named<S>])[],
    ),
  };
}

export type Grammar<S extends AnyStatement> = ReturnType<typeof grammarOf<S>>;
