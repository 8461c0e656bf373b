import { useCallback } from "react";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { spreadOf, textsBeside } from "../../app/fields/blocks/block-guide.ts";
import { outcomeOfOther } from "../../app/calculation/other-outcome.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { toolTable } from "../../app/document/work-tools.ts";
import { useShownName } from "../../app/document/shown-file.ts";
import { useEditor } from "../../app/document/store.ts";
import { blockSources, fieldOfWord, textWith, type BlockSource } from "./block-source.ts";
import { useGuidedBlock } from "../../app/place/open-call.ts";
import { comparableTools } from "./setup-variants.ts";
import { comparedValues, type SimulatedValue, type ComparedValue } from "./compared-values.ts";
import { usePageResult, type PageResult } from "./use-page-result.ts";

/** A word of a block with one of its texts, and the effect. */
export type TriedWord = ComparedValue & { readonly text: string };

/** A word of a block at several values. */
export interface TriedBlock {
  /** The line of the block in the open program; null for a sample. */
  readonly line: number | null;
  readonly tried: readonly TriedWord[];
  readonly box: Box;
}

/** Number of tools shown besides the called one. */
const MOST_OTHERS = 2;

/**
 * A tool by its number, with others of its orientation, with another nose radius if possible; only the present text if
 * there are none.
 */
function toolTexts(usual: string): readonly string[] {
  const { tools } = toolTable(),
    own = tools.find(({ T }) => String(T) === usual);
  if (!own) return [usual];
  const others = tools.filter(({ T, TO, RS }) => T !== own.T && TO === own.TO && RS !== own.RS).slice(0, MOST_OTHERS);
  return [own, ...(others.length > 0 ? others : comparableTools(tools, own))].map(({ T }) => String(T));
}

/** Whether two runs look the same: path, time, blank and part. */
const isAlike = (a: Outcome, b: Outcome): boolean => {
  const seen = ({ run, simulation }: Outcome) =>
    JSON.stringify([run.blank, run.seconds, run.steps.map(({ from, move }) => [from, move]), simulation.final]);
  return seen(a) === seen(b);
};

/** A program with moves, and without anything that the control would refuse. */
const isRun = ({ run }: Outcome): boolean =>
  run.steps.length > 0 && run.issues.every(({ issue }) => issue.severity !== "error");

async function tryAt(source: BlockSource, word: string, goesOn: () => boolean): Promise<TriedBlock | null> {
  const field = fieldOfWord(source.statement, word),
    spread = field && spreadOf(field);
  if (!field || !spread) return null;
  const usual = field.read(source.statement);
  const ran: (SimulatedValue & { readonly text: string })[] = [];
  for (const text of "tools" in spread ? toolTexts(usual) : textsBeside(spread, usual)) {
    if (!goesOn()) return null;
    const written = textWith(source, field, text);
    const outcome = written === null ? null : await outcomeOfOther(source.work(written), null);
    if (outcome) ran.push({ text, isUsual: text === usual, outcome });
  }
  const own = ran.find(({ isUsual }) => isUsual);
  if (!own || ran.every(({ outcome }) => isAlike(outcome, own.outcome))) return null;
  const shown = comparedValues(ran, isRun);
  return shown && { line: source.line, ...shown };
}

/** Simulates a program with other texts in a word of one of its blocks; null if that makes no difference. */
async function tryBlock(kind: BlockKind, word: string, goesOn: () => boolean): Promise<TriedBlock | null> {
  for (const source of blockSources(kind, word)) {
    const shown = await tryAt(source, word, goesOn);
    if (shown || !goesOn()) return shown;
  }
  return null;
}

/** A word of a block at several values, recomputed when the open work changes. */
export function useTriedBlock(kind: BlockKind, word: string): PageResult<TriedBlock> {
  const name = useShownName();
  const program = useEditor((s) => s.program);
  const line = useGuidedBlock((s) => s.block?.line ?? 0);
  const make = useCallback((goesOn: () => boolean) => tryBlock(kind, word, goesOn), [kind, word]);
  return usePageResult(
    `${kind}.${word}`,
    JSON.stringify([name, line, program?.text, program?.files?.map(({ text }) => text)]),
    make,
  );
}
