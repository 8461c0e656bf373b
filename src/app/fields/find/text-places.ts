import { blockNumbers, type Block, type Program } from "../../../nc/program.ts";
import { shownLabel } from "../../../nc/blocks/words.ts";
import { firstLine } from "../blocks/program-parts.ts";

/** A place in a program that one can go to. */
export interface TextPlace {
  readonly kind: "block" | "label" | "tool" | "cycle" | "parameter" | "structure";
  /** What is searched for there: `LBL 2`, `T 5`, `Q463`, a cycle or block number. */
  readonly key: string;
  /** Index of its block, and the number of that block. */
  readonly index: number;
  readonly number: number;
  /** The parameter on its line. */
  readonly q: string | null;
  readonly text: string;
}

/** Most places that are listed. */
const MOST = 100;

type Found = Pick<TextPlace, "kind" | "key"> & { readonly words: readonly string[] };

const sameCase = (text: string) => text.trim().replace(/\s+/g, " ").toUpperCase();

/** The label, tool, cycle or structure item of a block, with the words that find it. */
function namedPlace({ statement: s }: Block): Found | null {
  if (s.kind === "label" && s.label !== 0) {
    const label = shownLabel(s.label);
    return { kind: "label", key: `LBL ${label}`, words: [`LBL ${label}`, label] };
  }
  if (s.kind === "toolCall" && s.tool !== null) {
    const tool = shownLabel(s.tool);
    return { kind: "tool", key: `T ${tool}`, words: [`T${tool}`, `T ${tool}`, `TOOL CALL ${tool}`, tool] };
  }
  if (s.kind === "cycle") {
    const cycle = String(s.cycle);
    return { kind: "cycle", key: cycle, words: [cycle, `CYCL DEF ${cycle}`, s.name] };
  }
  if (s.kind === "structure") return { kind: "structure", key: "*", words: [s.text] };
  return null;
}

const PARAMETER = /Q[LRS]?\d+/gi;
/** A typed parameter: the letters with the first digits of its number. */
const TYPED_PARAMETER = /^Q[LRS]?\d*$/;

/** Lines of a block with a parameter whose name begins as typed. */
function parametersOf({ raw }: Block, typed: string): readonly { readonly q: string; readonly line: string }[] {
  if (!raw.toUpperCase().includes(typed)) return [];
  return raw.split(/[\r\n]+/).flatMap((line) => {
    const names = (line.replace(/;.*/, "").match(PARAMETER) ?? []).map((name) => name.toUpperCase());
    return [...new Set(names)].filter((q) => q.startsWith(typed)).map((q) => ({ q, line }));
  });
}

/** How well a word matches: as a whole, at its start, or inside; null if it does not. */
function rankOf(words: readonly string[], typed: string): number | null {
  const all = words.map(sameCase);
  if (all.includes(typed)) return 0;
  if (all.some((word) => word.startsWith(typed))) return 1;
  return typed.length > 1 && all.some((word) => word.includes(typed)) ? 2 : null;
}

/** Places that match what is typed, best first: a block number, label, tool, cycle, parameter or structure item. */
export function placesIn(program: Program, input: string): readonly TextPlace[] {
  const typed = sameCase(input);
  if (typed === "") return [];
  const numbers = blockNumbers(program);
  const ranked: { readonly place: TextPlace; readonly rank: number }[] = [];
  const seen = new Set<number>();
  program.blocks.forEach((block, index) => {
    const number = numbers[index] ?? 0;
    const add = (rank: number | null, found: Pick<TextPlace, "kind" | "key">, q: string | null, text: string) => {
      if (rank !== null) ranked.push({ rank, place: { kind: found.kind, key: found.key, index, number, q, text } });
    };
    const isCounted = block.statement.kind !== "empty" && !seen.has(number);
    if (isCounted) {
      seen.add(number);
      add(
        /^\d+$/.test(typed) ? rankOf([String(number)], typed) : null,
        { kind: "block", key: String(number) },
        null,
        firstLine(block.raw),
      );
    }
    if (TYPED_PARAMETER.test(typed)) {
      for (const { q, line } of parametersOf(block, typed))
        add(q === typed ? 0 : 1, { kind: "parameter", key: q }, q, line.replace(/~\s*$/, "").trim());
      return;
    }
    const named = namedPlace(block);
    if (named) add(rankOf(named.words, typed), named, null, firstLine(block.raw));
  });
  return ranked
    .sort((a, b) => a.rank - b.rank || Number(b.place.kind === "block") - Number(a.place.kind === "block"))
    .slice(0, MOST)
    .map(({ place }) => place);
}
