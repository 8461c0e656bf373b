import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import type { TextFormula } from "../../nc/words.ts";
import { PROGRAM_CYCLE } from "../../nc/blocks/cycle-line.ts";
import { fileKey, nameInCycle } from "../state/program-files.ts";

interface TextFile {
  readonly name: string;
  readonly text: string;
}

/**
 * Texts without any of these name no other file, and need not be read for it: most of a folder is long and calls
 * nothing.
 */
const MAY_NAME =
  /(?:CALL|SEL)[ \t]+PGM|SEL[ \t]+CONTOUR|CONTOUR[ \t]+DEF|DECLARE|CYCL[ \t]+DEF[ \t]*12|BLANK|FILE|FORM[ \t]+ROTATION|QS\d/i;
const BEGIN = /^[ \t]*(?:N?\d+[ \t]+)?BEGIN[ \t]+PGM/im;

function quotedIn(text: TextFormula): readonly string[] {
  if (text.kind === "quoted") return [text.text];
  return text.kind === "joined" ? text.parts.flatMap(quotedIn) : [];
}

/** Every file that a value names anywhere in it: blocks of many kinds do, in places of their own. */
function filesIn(value: unknown): readonly string[] {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, held]) =>
    key === "file" && typeof held === "string" ? [held] : filesIn(held),
  );
}

function namedBy(s: Statement): readonly string[] {
  if (s.kind === "assignText") return quotedIn(s.text);
  if (s.kind === "cycleLine") return s.cycle === PROGRAM_CYCLE && s.line === 1 ? [nameInCycle(s.text)] : [];
  return filesIn(s);
}

/** Keys of all files that a program may name. */
export const namedFiles = (program: Program): ReadonlySet<string> =>
  new Set(program.blocks.flatMap(({ statement }) => namedBy(statement)).map(fileKey));

/** Keys of the files that a program reaches by calls of calls, itself among them. */
function reachedFrom(key: string, names: ReadonlyMap<string, ReadonlySet<string>>): ReadonlySet<string> {
  const seen = new Set([key]);
  for (const next of seen) for (const name of names.get(next) ?? []) if (names.has(name)) seen.add(name);
  return seen;
}

/**
 * Files that were opened together: which one runs, and the programs among them that each could be a work of its own.
 */
export interface MainPrograms {
  readonly index: number;
  /** False where it is not clear which one runs: no program is called by none, or several are. */
  readonly sure: boolean;
  /** Programs that no other calls, each with the files that it reaches by calls of calls, in the order of the files. */
  readonly free: readonly { readonly index: number; readonly calls: readonly number[] }[];
}

/**
 * Which of the files that were opened together runs: the program that no other calls. Where that is none or several,
 * the one that reaches most of the others, then the first; `sure` is false then.
 */
export function mainOf(files: readonly TextFile[], parse: (text: string) => Program): MainPrograms {
  const keys = files.map(({ name }) => fileKey(name));
  const names = new Map(
    files.map(({ text }, i) => [keys[i] ?? "", MAY_NAME.test(text) ? namedFiles(parse(text)) : new Set<string>()]),
  );
  const called = new Map<string, string[]>();
  for (const [by, all] of names)
    for (const name of all) if (name !== by) called.set(name, [...(called.get(name) ?? []), by]);
  const programs = files.flatMap(({ text }, i) => (BEGIN.test(text) ? [i] : []));
  const reached = (i: number) => reachedFrom(keys[i] ?? "", names);
  const free = programs
    .filter((i) => !called.has(keys[i] ?? ""))
    .map((index) => {
      const all = reached(index);
      return { index, calls: keys.flatMap((key, i) => (i !== index && all.has(key) ? [i] : [])) };
    });
  const [only] = free;
  if (only && free.length === 1) return { index: only.index, sure: true, free };
  const candidates = free.length > 0 ? free.map(({ index }) => index) : programs;
  const [best = 0] = candidates.toSorted((a, b) => reached(b).size - reached(a).size);
  return { index: best, sure: false, free };
}
