import { SCREENS, type Screen } from "./screens.ts";
import { WORKS, type MeasuredWork } from "./works.ts";

/** The cases for a program on a screen; "3d" plays it ten times as fast in the 3D view, "orbit" turns it there. */
export const CASES = ["1x", "10x", "pan", "zoom", "3d", "orbit", "key"] as const;
export type CaseName = (typeof CASES)[number];

export interface BenchOptions {
  readonly screens: readonly Screen[];
  readonly works: readonly MeasuredWork[];
  readonly cases: readonly CaseName[];
  /** Number of rounds that count frames, duration of each, s; number of keys pressed. */
  readonly rounds: number;
  readonly seconds: number;
  readonly keys: number;
  /** The folder of the built page; null: this project's own, rebuilt when it is older than its sources. */
  readonly built: string | null;
  readonly isJson: boolean;
  /** Whether the tables are also written to docs/performance.md. */
  readonly isWritten: boolean;
}

/** The items that an option names, in full or in part; all where the option is missing. */
function chosenOf<T>(
  option: string,
  given: string | undefined,
  all: readonly T[],
  nameOf: (each: T) => string,
): readonly T[] {
  if (given === undefined) return all;
  const words = given.split(",");
  for (const word of words)
    if (!all.some((each) => nameOf(each).includes(word)))
      throw new Error(`--${option}=${word} is none of: ${all.map(nameOf).join(", ")}`);
  const isExact = words.every((word) => all.some((each) => nameOf(each) === word));
  return all.filter((each) => words.some((word) => (isExact ? nameOf(each) === word : nameOf(each).includes(word))));
}

const KNOWN = ["screen", "work", "case", "rounds", "seconds", "keys", "built", "json", "write", "quick"];

/** Reads the command line. */
export function readOptions(args: readonly string[]): BenchOptions {
  const given = new Map(
    args.map((arg) => {
      const [, name = "", value = ""] = /^--([a-z]+)(?:=(.*))?$/.exec(arg) ?? [];
      if (!KNOWN.includes(name))
        throw new Error(`${arg} is not understood. Known: ${KNOWN.map((known) => `--${known}`).join(" ")}`);
      return [name, value];
    }),
  );
  const number = (name: string, otherwise: number) => {
    const value = Number(given.get(name) ?? otherwise);
    if (!(value > 0)) throw new Error(`--${name} needs a number above zero`);
    return value;
  };
  const isQuick = given.has("quick");
  return {
    screens: chosenOf("screen", given.get("screen"), SCREENS, ({ name }) => name),
    works: chosenOf("work", given.get("work"), WORKS, ({ name }) => name),
    cases: chosenOf("case", given.get("case"), CASES, (name) => name),
    rounds: Math.round(number("rounds", isQuick ? 2 : 5)),
    seconds: number("seconds", isQuick ? 1.5 : 3),
    keys: Math.round(number("keys", isQuick ? 6 : 20)),
    built: given.get("built") ?? null,
    isJson: given.has("json"),
    isWritten: given.has("write"),
  };
}
