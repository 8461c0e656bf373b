import { readFileSync } from "node:fs";
import { planner } from "../src/app/calculation/plan.ts";
import { parse } from "../src/nc/parse.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { simulate, incrementalSimulator } from "../src/sim/simulate.ts";
import { traceStock } from "../src/sim/tracing.ts";

/** Programs of several operations, of which one changes. */
const PROGRAMS = ["flange", "shaft"] as const;
const shop = { tools: shippedTools, rapid: 10_000 };
/** Number of different states tried in turn: results of earlier states cannot be reused. */
const STATES = 64;

/** The changed operation, as a fraction of the program; null: a comment that moves nothing. */
export const PLACES = [
  ["first", 0],
  ["middle", 0.5],
  ["last", 1],
  ["nothing", null],
] as const;

/**
 * A program with another safety clearance in one of its cycles, different each time: this changes each move to its
 * start.
 */
export function changedAt(text: string, place: number | null, count: number): string {
  if (place === null) return text.replace("END PGM", `; ${count}\n$&`);
  const values = [...text.matchAll(/CYCL DEF 8\d\d[\s\S]*?Q460=\+?\d+/g)];
  const value = values[Math.round(place * (values.length - 1))];
  if (!value) throw new Error("no cycle to change");
  const end = value.index + value[0].length;
  return `${text.slice(0, end)}.${100 + (count % STATES)}${text.slice(end).replace(/^\.\d+/, "")}`;
}

/** Plans one state of a program after another, as the page does with each key. */
export function planningAgain(): (text: string) => ReturnType<typeof run> {
  const plan = planner(),
    table = { tools: shippedTools, mills: [], refused: new Map() };
  return (text) => plan({ version: 0, text, table, rapid: shop.rapid, control: "TNC 640" }).run;
}

/**
 * The cost of a change of the first, the middle and the last operation: planned from scratch, and from the previous
 * state.
 */
export function* changedOperations(): Generator<readonly [name: string, work: (count: number) => unknown]> {
  for (const name of PROGRAMS) {
    const text = readFileSync(`src/examples/${name}.h`, "utf8");
    yield [`plan ${name}`, (count) => run(parse(changedAt(text, 1, count)), { ...shop, tracing: traceStock })];
    for (const [where, place] of PLACES) {
      const plan = planningAgain();
      yield [`plan ${name}, ${where} changed`, (count) => plan(changedAt(text, place, count))];
    }
    yield [`stock ${name}`, () => simulate(run(parse(text), { ...shop, tracing: traceStock }))];
    for (const [where, place] of PLACES) {
      const plan = planningAgain(),
        proved = incrementalSimulator();
      yield [`stock ${name}, ${where} changed`, (count) => proved(plan(changedAt(text, place, count)))];
    }
  }
}
