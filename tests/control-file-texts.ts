import * as fc from "fast-check";
import { NC_LANGUAGES } from "../src/nc/nc-languages.ts";
import type { Cycle } from "../src/cycles/define.ts";
import { cuttingCycles } from "../src/cycles/index.ts";
import type { Param } from "../src/cycles/params.ts";
import type { Statement } from "../src/nc/statement.ts";
import { exampleJob, newRow, type SetJob } from "../src/program/job/job.ts";
import { JOB_LAYOUTS } from "../src/program/machine/nc-output.ts";

/* Random jobs and statements for the grammar of a program file. */

const ODD = ["", "abc", "1e3", "--5", "Q5", "QL3", "FAUTO", "0", "1/0", "7,5", " 12 ", "75/2+1", "1/3"];
const odd = fc.constantFrom(...ODD, "99999999");
const typed = (p: Param) => {
  const [least, most] = [Math.max(p.range[0], -90), Math.min(p.range[1], 90)];
  const usual = p.choices
    ? fc.constantFrom(...p.choices.map(String))
    : fc.integer({ min: Math.ceil(least * 1000), max: Math.floor(most * 1000) }).map((n) => String(n / 1000));
  return fc.oneof({ weight: 40, arbitrary: usual }, { weight: 1, arbitrary: odd });
};
/**
 * A typed position has no limit and is printed as typed: beyond ±99999.9999 the text is refused, so none is generated.
 */
const length = fc.oneof(
  { weight: 20, arbitrary: fc.integer({ min: -60000, max: 90000 }).map((n) => String(n / 1000)) },
  {
    weight: 1,
    arbitrary: fc.constantFrom(...ODD),
  },
);
const row = fc
  .record({
    id: fc.uuid(),
    kind: fc.constantFrom(
      "L" as const,
      "RND" as const,
      "CHF" as const,
      "CR" as const,
      "CC" as const,
      "C" as const,
      "CT" as const,
    ),
    x: length,
    z: length,
    r: length,
    turn: fc.constantFrom("cw" as const, "ccw" as const),
    incrementalX: fc.boolean(),
    incrementalZ: fc.boolean(),
    angle: fc.oneof(fc.constant(""), length),
    length: fc.oneof(fc.constant(""), length),
    tangent: fc.boolean(),
    second: fc.boolean(),
  })
  .map(({ id, ...given }) => newRow(id, given));

const functionNumber = fc.integer({ min: 0, max: 999 });
const outputs = fc.record({
  spindleOn: functionNumber,
  spindleOff: fc.option(functionNumber),
  retract: fc.constantFrom("position" as const, "limit" as const),
  end: fc.constantFrom(30 as const, 2 as const),
  numbered: fc.boolean(),
  newLine: fc.constantFrom("\n" as const, "\r\n" as const),
  capitals: fc.boolean(),
});

/** Jobs of one cycle as a user may type them, usually with values in range, in each language, layout and setting. */
export const typedJobsOf = (cycle: Cycle): fc.Arbitrary<SetJob> =>
  fc
    .record({
      draft: fc.record(Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, typed(p)]))),
      contour: fc.oneof(fc.constant(exampleJob(cycle).contour), fc.array(row, { maxLength: 8 })),
      start: fc.record({ x: length, z: length }),
      name: fc.oneof(fc.constant("PART"), fc.string({ maxLength: 12, unit: "binary" })),
      parameters: fc.oneof(
        fc.constant({}),
        length.map((Q5) => ({ Q5 })),
      ),
      ncLanguage: fc.constantFrom(...NC_LANGUAGES),
      perRevolution: fc.boolean(),
      layout: fc.constantFrom(...JOB_LAYOUTS),
      output: outputs,
    })
    .map(({ draft, ...rest }) => ({ ...exampleJob(cycle), drafts: { [cycle.number]: draft }, ...rest }));

/** Jobs of any cycle. */
export const typedJobs: fc.Arbitrary<SetJob> = fc.constantFrom(...cuttingCycles).chain(typedJobsOf);

/** Limits of positions, deltas and feeds in the input formats, and the number of parameters of a program. */
const [POSITION, DELTA, FEED, LOCAL] = [99999.9999, 99.9999, 99999.999, 500];
const DELTAS = ["deltaLength", "deltaRadius"];
const POSITIVE = ["feed", "functionFeed", "speed", "cuttingSpeed", "limit"];

function within(n: number, key: string): number {
  if (DELTAS.includes(key)) return n % DELTA;
  if (POSITIVE.includes(key)) return Math.abs(n) % FEED;
  return Math.abs(n) > POSITION ? n % POSITION : n;
}
const rounded = (n: number) => Math.round(n * 10000) / 10000;

/** The value with numbers and parameters that a control can store; `key` is the word of the value. */
function held(value: unknown, key: string): unknown {
  if (typeof value === "number") return rounded(within(value, key));
  if (typeof value === "string") {
    const local = key === "parameter" || key === "target" ? /^(Q[LR])(\d+)$/.exec(value) : null;
    return local ? `${local[1]}${Number(local[2]) % LOCAL}` : value;
  }
  if (Array.isArray(value)) return value.map((each) => held(each, key));
  if (typeof value !== "object" || value === null) return value;
  // The value of a feed belongs to its word, the value of any other word to that word.
  const under = (name: string) => (name === "value" ? key : name);
  return Object.fromEntries(Object.entries(value).map(([name, each]) => [name, held(each, under(name))]));
}

/** Statements of a valid program: their values are storable on a control, and each label is set once. */
export function asControlStores(list: readonly Statement[]): readonly Statement[] {
  const labels = new Set<string | number>([0]);
  return list
    .filter((s) => s.kind !== "begin" && s.kind !== "end")
    .map((s) => held(s, s.kind) as Statement)
    .filter((s) => {
      if (s.kind !== "label" || s.label === 0) return true;
      const isNew = !labels.has(s.label);
      labels.add(s.label);
      return isNew;
    });
}
