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
 * Texts without any of these words name no other file and need not be parsed: most files of a folder are long and call
 * nothing.
 */
const MAY_NAME =
  /(?:CALL|SEL)[ \t]+PGM|SEL[ \t]+CONTOUR|CONTOUR[ \t]+DEF|DECLARE|CYCL[ \t]+DEF[ \t]*12|BLANK|FILE|FORM[ \t]+ROTATION|QS\d/i;
const BEGIN = /^[ \t]*(?:N?\d+[ \t]+)?BEGIN[ \t]+PGM/im;

function quotedIn(text: TextFormula): readonly string[] {
  if (text.kind === "quoted") return [text.text];
  return text.kind === "joined" ? text.parts.flatMap(quotedIn) : [];
}

/** All file names anywhere in a value: many kinds of blocks hold them in different members. */
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

/** Keys of the files that a program reaches by nested calls, itself included. */
function reachedFrom(key: string, names: ReadonlyMap<string, ReadonlySet<string>>): ReadonlySet<string> {
  const seen = new Set([key]);
  for (const next of seen) for (const name of names.get(next) ?? []) if (names.has(name)) seen.add(name);
  return seen;
}

/** Main program among files opened together, and the programs that could each stand alone. */
export interface MainPrograms {
  readonly index: number;
  /** False where the main program is ambiguous: every program is called, or several are not. */
  readonly sure: boolean;
  /** Programs that no other calls, each with the files it reaches by nested calls, in file order. */
  readonly free: readonly { readonly index: number; readonly calls: readonly number[] }[];
}

/**
 * Finds the main program among files opened together: the one that no other calls. Else the one that reaches most
 * others, then the first; `sure` is false then.
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
