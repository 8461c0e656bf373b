import {
  missesBlank,
  clampingBodies,
  type Clamped,
  type Clamping,
  type ClampingKind,
} from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import {
  ANY_NUMBER,
  CENTRE_ANGLE,
  CLAMPING_WORDS,
  LEAST_ANGLE,
  MOST_ANGLE,
  neededWords,
  type ClampingWord,
} from "./words.ts";

/** Clamping of a comment, in the unit of its program; `what`: words not understood. */
export interface ReadClamping {
  readonly kind: ClampingKind | null;
  readonly values: Readonly<Partial<Record<ClampingWord, number>>>;
  readonly what: readonly string[];
}

/** Other spellings of words with a number. */
const ALSO: Readonly<Record<string, ClampingWord>> = {
  Ø: "D",
  "⌀": "D",
  DIA: "D",
  CHUCK: "SIZE",
  COLLET: "SIZE",
  NOSE: "SIZE",
};
const KINDS: readonly (readonly [RegExp, ClampingKind])[] = [
  [/SOFT/, "softJaws"],
  [/COLLET/, "collet"],
  [/CENT(RE|ER)/, "centres"],
  [/INSIDE/, "chuckInside"],
  [/OUTSIDE/, "chuckOutside"],
];
/** Words that belong to a kind and mean nothing alone. */
const SILENT = /^(CHUCK|SOFT|JAWS?|COLLET|BETWEEN|CENT(RE|ER)S?|INSIDE|OUTSIDE|TAILSTOCK|LIMITS?|MM|INCH)$/;
/** A word with its number, or one alone. */
const TOKEN = /([^\s\d:=+.,;-]+)(?:\s*(?:[:=]\s*)?([+-]?(?:\d+(?:[.,]\d+)?|[.,]\d+)))?|\S/gu;

const AXIS = /\b(FACE|TIP|LIMIT)\s+([ZX])(?=\s*(?:[:=]\s*)?[+-]?[\d.])/gu;

const known = (word: string): ClampingWord | undefined => ALSO[word] ?? CLAMPING_WORDS.find((w) => w === word);
const takes = (word: ClampingWord, n: number) =>
  ANY_NUMBER.has(word) || (word === "ANGLE" ? n >= LEAST_ANGLE && n <= MOST_ANGLE : n > 0);

/** Reads a comment, without its `;`; null for one without a clamping. Spelling, order and decimal sign are free. */
export function readClamping(comment: string): ReadClamping | null {
  // An axis may precede its value: FACE Z-75, LIMIT Z-70.
  const text = /^\s*CLAMPING\b[\s:=]*(.*)/iu
    .exec(comment)?.[1]
    ?.toUpperCase()
    .replace(AXIS, (_, word: string, axis: string) => (word === "LIMIT" ? word + axis : word));
  if (text === undefined) return null;
  const [values, what]: [Partial<Record<ClampingWord, number>>, string[]] = [{}, []];
  for (const [whole, word = "", digits] of text.matchAll(TOKEN)) {
    const name = known(word),
      n = Number(digits?.replace(",", "."));
    if (name && digits !== undefined && values[name] === undefined && takes(name, n)) values[name] = n;
    else if ((digits !== undefined || !SILENT.test(word)) && /[^\s,;:-]/u.test(whole)) what.push(whole);
  }
  return { kind: KINDS.find(([words]) => words.test(text))?.[1] ?? null, values, what };
}

/** The clamping, or its missing words. */
export function clampingOf({ kind, values }: ReadClamping, mm: (n: number) => number): Clamping | readonly string[] {
  if (!kind) return ["CHUCK OUTSIDE"];
  const isOnCentre = values.QUILL !== undefined || values.TIP !== undefined;
  const needed = [...new Set([...neededWords(kind), ...(isOnCentre ? (["QUILL", "TIP"] as const) : [])])];
  const missing = needed.filter((word) => values[word] === undefined);
  if (missing.length > 0) return missing;
  const of = (word: ClampingWord) => mm(values[word] ?? 0),
    has = (word: ClampingWord) => values[word] !== undefined;
  // A chuck cannot grip a larger diameter from outside.
  if (kind !== "centres" && of("SIZE") <= of("D")) return ["SIZE"];
  return {
    kind,
    diameter: of("D"),
    length: kind === "centres" ? 0 : of("LENGTH"),
    face: of("FACE"),
    ...(kind !== "centres" && { size: of("SIZE") }),
    ...(isOnCentre && { tailstock: { quill: of("QUILL"), tip: of("TIP"), angle: values.ANGLE ?? CENTRE_ANGLE } }),
    ...((has("LIMITZ") || has("LIMITX")) && {
      limit: { ...(has("LIMITZ") && { z: of("LIMITZ") }), ...(has("LIMITX") && { x: of("LIMITX") }) },
    }),
  };
}

/** Runs a comment, which may state the clamping, once per program. */
export function takeComment(machine: Machine, comment: string, index: number): void {
  const read = readClamping(comment);
  if (!read) return;
  const { clamping } = machine.now;
  if (clamping?.index === index) return;
  if (clamping) return machine.log.report(programIssue("clampingTwice", "warning", {}), index);
  const made = clampingOf(read, (n) => machine.length(n));
  if (read.what.length > 0)
    machine.log.report(programIssue("clampingUnread", "info", { what: read.what.join(" ").slice(0, 40) }), index);
  if ("kind" in made) machine.set({ clamping: { index, made } });
  else machine.log.report(programIssue("clampingIncomplete", "info", { words: made.join(", ") }), index);
}

/** Clamping of a run; null without one. One that does not grip the blank is reported. */
export function clampedOf({ now, log }: Machine, blank: readonly Ring[]): Clamped | null {
  if (!now.clamping) return null;
  const { index, made } = now.clamping;
  if (missesBlank(made, blank))
    log.report(programIssue("clampingMisses", "warning", { diameter: made.diameter }), index);
  return { clamping: made, bodies: clampingBodies(made, blank) };
}
