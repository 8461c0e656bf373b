import type { Program } from "../nc/program.ts";
import type { Statement, TextFormula } from "../nc/statement.ts";
import { PROGRAM_CYCLE } from "./program-calls.ts";
import { fileKey, nameInCycle } from "./program-files.ts";

interface TextFile {
  readonly name: string;
  readonly text: string;
}

/** Texts without any of these name no other file, and need not be read for it: most of a folder is long and calls nothing. */
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
  return Object.entries(value).flatMap(([key, held]) => (key === "file" && typeof held === "string" ? [held] : filesIn(held)));
}

function namedBy(s: Statement): readonly string[] {
  if (s.kind === "assignText") return quotedIn(s.text);
  if (s.kind === "cycleLine") return s.cycle === PROGRAM_CYCLE && s.line === 1 ? [nameInCycle(s.text)] : [];
  return filesIn(s);
}

/** Keys of all files that a program may name. */
export const namedFiles = (program: Program): ReadonlySet<string> =>
  new Set(program.blocks.flatMap(({ statement }) => namedBy(statement)).map(fileKey));

/** How many of the files a program reaches by calls of calls, itself not counted. */
function reachOf(key: string, names: ReadonlyMap<string, ReadonlySet<string>>): number {
  const seen = new Set([key]);
  for (const next of seen) for (const name of names.get(next) ?? []) if (names.has(name)) seen.add(name);
  return seen.size - 1;
}

/**
 * Which of the files that were opened together runs: the program that no other calls. Where that is none or several, the one
 * that reaches most of the others, then the first; `sure` is false then.
 */
export function mainOf(files: readonly TextFile[], parse: (text: string) => Program): { readonly index: number; readonly sure: boolean } {
  const keys = files.map(({ name }) => fileKey(name));
  const names = new Map(files.map(({ text }, i) => [keys[i] ?? "", MAY_NAME.test(text) ? namedFiles(parse(text)) : new Set<string>()]));
  const isCalled = (key: string) => [...names].some(([by, called]) => by !== key && called.has(key));
  const programs = files.flatMap(({ text }, i) => (BEGIN.test(text) ? [i] : []));
  const free = programs.filter((i) => !isCalled(keys[i] ?? ""));
  const [only] = free;
  if (only !== undefined && free.length === 1) return { index: only, sure: true };
  const reach = (i: number) => reachOf(keys[i] ?? "", names);
  const [best = 0] = (free.length > 0 ? free : programs).toSorted((a, b) => reach(b) - reach(a));
  return { index: best, sure: false };
}
