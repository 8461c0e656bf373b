import { readFileSync } from "node:fs";
import { parse } from "../src/nc/parse.ts";
import { planMemory } from "../src/program/plan-memory.ts";
import { run } from "../src/program/run.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";
import { simulate, simulating } from "../src/sim/simulate.ts";
import { tracing } from "../src/sim/tracing.ts";
import { tracingAgain } from "../src/sim/tracing-again.ts";

/** Programs of several operations that are changed at one of them. */
const PROGRAMS = ["flange", "shaft"] as const;
const shop = { tools: shippedTools, rapid: 10_000 };

/** A program and the same with another safety clearance in one of its cycles: each move to its start is another one then. */
function bothAt(text: string, place: number): readonly [string, string] {
  const values = [...text.matchAll(/CYCL DEF 8\d\d[\s\S]*?Q460=\+?\d+/g)];
  const value = values[Math.round(place * (values.length - 1))];
  if (!value) throw new Error("no cycle to change");
  const end = value.index + value[0].length;
  return [text, `${text.slice(0, end)}.31${text.slice(end)}`];
}

/** What a change of the first, the middle and the last operation costs: from the beginning, and from what is known of the state before. */
export function* changedOperations(): Generator<readonly [name: string, work: (count: number) => unknown]> {
  for (const name of PROGRAMS) {
    const text = readFileSync(`src/examples/${name}.h`, "utf8");
    const [memory, traced] = [planMemory(), tracingAgain()];
    const last = bothAt(text, 1);
    yield [`run ${name}`, (count) => run(parse(last[count % 2] ?? text), { ...shop, tracing })];
    yield [`run ${name} again`, (count) => {
      memory.next();
      traced.next();
      return run(parse(last[count % 2] ?? text), { ...shop, memory, tracing: traced.tracing });
    }];
    yield [`stock ${name}`, () => simulate(run(parse(text), { ...shop, tracing }))];
    for (const [where, place] of [["first", 0], ["middle", 0.5], ["last", 1]] as const) {
      const both = bothAt(text, place).map((each) => run(parse(each), { ...shop, tracing }));
      const proved = simulating();
      yield [`stock ${name}, ${where} changed`, (count) => {
        const made = both[count % 2];
        return made && proved(made);
      }];
    }
  }
}
