import { Session } from "node:inspector";
import { afterAll, beforeAll, expect, test } from "vitest";
import { growthOf } from "../../scripts/lint/pattern-growth.mjs";
import { parse } from "../../src/nc/parse.ts";
import { sources } from "../sources.ts";
import { PUMPS } from "./pumps.ts";
import { PLANTED } from "./planted.ts";
import { READERS, type Reader } from "./readers.ts";
import { STORED } from "./stored-readers.ts";

/**
 * Every reader of text is linear: a text of eight times the length takes eight times the steps. Steps are counted, not
 * timed: how often each block of the source ran, and the characters and elements that built-in functions go through.
 * Patterns are not stepped through; each that a reader uses is proved linear by itself, here or by the lint rule.
 */
const [SHORT, TIMES] = [80, 8];
/** Nearly twice the linear growth: most texts are linear even where one is not. */
const MOST = TIMES * 1.8;
/** Steps that say nothing: of a part that only a longer text comes to. */
const FEW = 3000;
/** Blocks that are read before a count, so that none of its own is known from before. */
const OTHERS = Array.from({ length: 600 }, (_, i) => `LBL "${i}"\n`).join("");

const session = new Session();
const post = (method: string, params: object = {}): Record<string, unknown> => {
  let answer: Record<string, unknown> = {};
  session.post(method, params, (error, result) => {
    if (error) throw error;
    answer = (result ?? {}) as Record<string, unknown>;
  });
  return answer;
};

interface Range {
  readonly startOffset: number;
  readonly endOffset: number;
  readonly count: number;
}
interface Covered {
  readonly url: string;
  readonly functions: readonly { readonly functionName: string; readonly ranges: readonly Range[] }[];
}
/** Runs of the blocks of each function: the outer ones first, and only those that do not run as often as around them. */
type Runs = ReadonlyMap<string, readonly Range[]>;

/** Runs of each block of the source since the last call. */
function blocksRun(): Runs {
  const runs = new Map<string, readonly Range[]>();
  for (const { url, functions } of post("Profiler.takePreciseCoverage")["result"] as readonly Covered[]) {
    const [, file] = /\/(src\/.*|tests\/growth\/planted\.ts)$/.exec(url) ?? [];
    if (file === undefined) continue;
    for (const { functionName, ranges } of functions)
      if (ranges.some(({ count }) => count > 0)) runs.set(`${file} ${functionName} ${ranges[0]?.startOffset}`, ranges);
  }
  return runs;
}

/** How often a place of a function ran: as often as the innermost block around it. */
const runsAt = (ranges: readonly Range[] = [], place: number): number =>
  ranges.findLast(({ startOffset, endOffset }) => startOffset <= place && place < endOffset)?.count ?? 0;

/** Built-in steps and blocks of a longer text that ran more often than is linear. */
function grownFrom(less: Steps, more: Steps): string[] {
  const found: string[] = [];
  const compare = (at: string, before: number, after: number) => {
    if (after > MOST * (FEW + before)) found.push(`${at}: ${before} → ${after}`);
  };
  for (const [name, ranges] of more.blocks)
    for (const { startOffset, count } of ranges)
      compare(`${name} ${startOffset}`, runsAt(less.blocks.get(name), startOffset), count);
  for (const [name, count] of more.built) compare(`built-in ${name}`, less.built.get(name) ?? 0, count);
  return found;
}

const met = new WeakSet<RegExp>(),
  seen = new Map<string, RegExp>();
const built = new Map<string, number>();
/** Built-in functions that go through their whole text or list. */
const LONG: readonly (readonly [object, string])[] = [
  ...["indexOf", "includes", "lastIndexOf", "split", "trim", "trimEnd", "trimStart", "toUpperCase", "padEnd"].map(
    (name) => [String.prototype, name] as const,
  ),
  ...["indexOf", "includes", "slice", "concat", "splice", "shift", "unshift", "toSpliced", "with", "join"].map(
    (name) => [Array.prototype, name] as const,
  ),
];
let isCounting = false;
/** Patterns are noted while the short texts are read: those that are made of a longer one have no other form. */
let isNoting = false;
const restored: (() => void)[] = [];

const tracer = Error.prepareStackTrace;

beforeAll(() => {
  // What writes the stack of a thrown error is the runner's, not the reader's.
  Error.prepareStackTrace = (error) => String(error);
  parse(OTHERS);
  session.connect();
  post("Profiler.enable");
  post("Profiler.startPreciseCoverage", { callCount: true, detailed: true });
  for (const [of, name] of LONG) {
    const own = Object.getOwnPropertyDescriptor(of, name);
    if (!own) continue;
    const call = own.value as (...args: unknown[]) => unknown;
    Object.defineProperty(of, name, {
      ...own,
      value(this: { readonly length: number }, ...args: unknown[]) {
        const result = call.apply(this, args);
        const from = name === "indexOf" && typeof args[1] === "number" ? args[1] : 0;
        const made = name === "slice" ? (result as { readonly length: number }).length : this.length;
        const to = name === "indexOf" && typeof result === "number" && result >= 0 ? result : made;
        if (isCounting) built.set(name, (built.get(name) ?? 0) + Math.max(0, to - from));
        return result;
      },
    });
    restored.push(() => Object.defineProperty(of, name, own));
  }
  const exec = Object.getOwnPropertyDescriptor(RegExp.prototype, "exec");
  if (!exec) return;
  const call = exec.value as RegExp["exec"];
  Object.defineProperty(RegExp.prototype, "exec", {
    ...exec,
    value(this: RegExp, text: string) {
      if (isNoting && !met.has(this)) {
        met.add(this);
        seen.set(`/${this.source}/${this.flags}`, this);
      }
      return call.call(this, text);
    },
  });
  restored.push(() => Object.defineProperty(RegExp.prototype, "exec", exec));
});

afterAll(() => {
  Error.prepareStackTrace = tracer;
  for (const restore of restored) restore();
  session.disconnect();
});

interface Steps {
  readonly blocks: Runs;
  readonly built: ReadonlyMap<string, number>;
}

/** Steps of a reader over all its texts, with repeats up to this length. */
function steps({ read, frames = [], pumps = [] }: Reader, length: number): Steps {
  built.clear();
  blocksRun();
  isCounting = true;
  isNoting = length === SHORT;
  for (const [front, behind] of [["", "!"], ...frames])
    for (const pump of [...PUMPS, ...pumps]) read(front + pump.repeat(Math.ceil(length / pump.length)) + behind);
  isCounting = isNoting = false;
  return { blocks: blocksRun(), built: new Map(built) };
}

const growth = (reader: Reader) => grownFrom(steps(reader, SHORT), steps(reader, SHORT * TIMES));

test.each([...READERS, ...STORED].filter(({ bound }) => bound === undefined))("$name", (reader) => {
  expect(growth(reader)).toEqual([]);
});

test.each(PLANTED)("refuses a $name", (reader) => {
  expect(growth(reader)).not.toEqual([]);
});

test("no pattern that a reader makes as it runs is worse than linear", () => {
  expect(seen.size).toBeGreaterThan(200);
  // Those that stand in the source are read by the lint rule.
  const written = sources("src")
    .map(({ text }) => text)
    .join("\n");
  const made = [...seen].filter(([at]) => !written.includes(at));
  expect(made.length).toBeGreaterThan(10);
  expect(made.flatMap(([at, { source, flags }]) => (growthOf(source, flags) === null ? [] : [at]))).toEqual([]);
});
