import type { AnyIssue } from "../../i18n/message-texts.ts";
import { blockNumbers, type Program } from "../../nc/program.ts";
import { parse } from "../../nc/parse.ts";
import { byOperation, type ComparedOperation } from "../../program/compare/by-operation.ts";
import { comparePrograms, type BlockDifference } from "../../program/compare/compare.ts";
import { fileKey } from "../../program/state/program-files.ts";
import {
  changedEffects,
  consequenceOf,
  effectsByUnit,
  effectsOf,
  type Consequence,
} from "../../report/compare/consequences.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import type { FindingEntry } from "../../app/findings/entry.ts";
import { findingsOf } from "../../app/findings/findings.ts";
import { shownVerdict, type ShownVerdict } from "../../app/findings/verdict.ts";
import { filesOf, type ProgramWork } from "../../app/document/work.ts";

/** One file of both works, with its differences. */
export interface ComparedFile {
  /** Its name in the current work; else its name in the other one. */
  readonly name: string;
  readonly isMain: boolean;
  readonly before: Program;
  readonly after: Program;
  /** Numbers of their blocks. */
  readonly numbers: { readonly before: readonly number[]; readonly after: readonly number[] };
  /** For each block of the first program its partner in the second, -1 for none. */
  readonly partners: Int32Array;
  readonly operations: readonly ComparedOperation[];
}

function comparedFile(name: string, isMain: boolean, one: string, other: string): ComparedFile {
  const [before, after] = [parse(one), parse(other)];
  const comparison = comparePrograms(before, after);
  const operations = byOperation(before, after, comparison);
  const numbers = { before: blockNumbers(before), after: blockNumbers(after) };
  return { name, isMain, before, after, numbers, partners: comparison.partners, operations };
}

/**
 * Compares two works, file by file: the main programs, then the other files by name. Identical other files are left
 * out.
 */
export function comparedFiles(before: ProgramWork, after: ProgramWork): readonly ComparedFile[] {
  const beside = new Map(
    [...filesOf(after), ...filesOf(before)].map(({ name }) => [fileKey(name), name] as const).reverse(),
  );
  const textIn = (work: ProgramWork, key: string) =>
    filesOf(work).find(({ name }) => fileKey(name) === key)?.text ?? "";
  const pairs = [...beside].reverse().map(([key, name]) => [name, textIn(before, key), textIn(after, key)] as const);
  return [
    comparedFile(after.name, true, before.text, after.text),
    ...pairs
      .filter(([, one, other]) => one !== other)
      .map(([name, one, other]) => comparedFile(name, false, one, other)),
  ];
}

/** Verdict and findings of one program. */
interface Judgement {
  readonly verdict: ShownVerdict;
  readonly entries: readonly FindingEntry[];
}

/** A finding that only one program has, with the cycle it is about. */
export interface UnmatchedFinding {
  readonly issue: AnyIssue;
  readonly cycle: number | null;
}

/** The effects of the differences. */
export interface Consequences {
  readonly whole: Consequence;
  /** By file, then by operation. */
  readonly operations: readonly (readonly Consequence[])[];
  readonly before: ShownVerdict;
  readonly after: ShownVerdict;
  readonly came: readonly UnmatchedFinding[];
  readonly went: readonly UnmatchedFinding[];
}

const judgementOf = (outcome: Outcome): Judgement => {
  const entries = findingsOf(null, outcome);
  return { verdict: shownVerdict(entries, outcome), entries };
};

/**
 * Findings of one list that the other lacks. Findings of the same kind at the same field are counted, and the surplus
 * is returned.
 */
function unmatchedFindings(
  own: readonly FindingEntry[],
  others: readonly FindingEntry[],
  { run }: Outcome,
): readonly UnmatchedFinding[] {
  const nameOf = ({ issue, at }: FindingEntry) => `${issue.severity} ${issue.code} ${at ?? ""}`;
  const count = new Map<string, number>();
  for (const entry of others) count.set(nameOf(entry), (count.get(nameOf(entry)) ?? 0) + 1);
  return own
    .filter((entry) => {
      const left = count.get(nameOf(entry)) ?? 0;
      count.set(nameOf(entry), left - 1);
      return left <= 0;
    })
    .map(({ issue, operation }) => ({
      issue,
      cycle: operation === null ? null : (run.operations[operation]?.cycle ?? null),
    }));
}

/** The effects of the differences, from the results of both programs. */
export function consequencesOf(files: readonly ComparedFile[], before: Outcome, after: Outcome): Consequences {
  const [one, other] = [judgementOf(before), judgementOf(after)];
  return {
    whole: { before: effectsOf(before), after: effectsOf(after) },
    operations: files.map(({ name, isMain, before: was, after: is, operations }) => {
      const file = isMain ? null : name;
      const [effectsBefore, effectsAfter] = [effectsByUnit(before, was, file), effectsByUnit(after, is, file)];
      return operations.map((operation) => consequenceOf(operation, effectsBefore, effectsAfter));
    }),
    before: one.verdict,
    after: other.verdict,
    came: unmatchedFindings(other.entries, one.entries, after),
    went: unmatchedFindings(one.entries, other.entries, before),
  };
}

/** True for differences in comment or spelling only. */
export const isFormattingOnly = ({ kind }: BlockDifference): boolean => kind === "note" || kind === "form";

/** Number of differences by sort. */
export interface Tally {
  readonly values: number;
  readonly added: number;
  readonly removed: number;
  readonly moved: number;
  readonly operationsAdded: number;
  readonly operationsRemoved: number;
  readonly operationsMoved: number;
  readonly written: number;
}

/** Counts the differences; operations added, removed or moved as a whole count once, without their blocks. */
export function tallyOf(files: readonly ComparedFile[]): Tally {
  const operations = files.flatMap((file) => file.operations);
  const countWithFate = (fate: ComparedOperation["outcome"]) =>
    operations.filter((each) => each.outcome === fate).length;
  const blocks = (kind: BlockDifference["kind"], ...besides: readonly ComparedOperation["outcome"][]) =>
    operations.reduce(
      (sum, { outcome, differences }) =>
        besides.includes(outcome) ? sum : sum + differences.filter((each) => each.kind === kind).length,
      0,
    );
  return {
    values: operations.reduce(
      (sum, { differences }) => sum + differences.reduce((n, { words }) => n + words.length, 0),
      0,
    ),
    added: blocks("added", "added"),
    removed: blocks("removed", "removed"),
    moved: blocks("moved", "moved"),
    operationsAdded: countWithFate("added"),
    operationsRemoved: countWithFate("removed"),
    operationsMoved: countWithFate("moved"),
    written: blocks("note") + blocks("form"),
  };
}

/** True for an operation with anything to list. */
export const isListed = (
  { differences, outcome }: ComparedOperation,
  consequence: Consequence | undefined,
  withWriting: boolean,
): boolean =>
  outcome !== "kept" ||
  differences.some((each) => withWriting || !isFormattingOnly(each)) ||
  (consequence !== undefined && changedEffects(consequence).length > 0);
