import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parse } from "../src/nc/parse.ts";
import { issuesOf, print } from "../src/nc/program.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { listing } from "../src/report/listing.ts";
import { report } from "../src/report/report.ts";
import { simulate } from "../src/sim/simulate.ts";
import { traceStock } from "../src/sim/tracing.ts";

const programs = Object.entries(
  import.meta.glob<string>("./programs/*.h", { query: "?raw", import: "default", eager: true }),
);
const broken = Object.entries(
  import.meta.glob<string>("./programs/bad/*.h", { query: "?raw", import: "default", eager: true }),
);
const shop = { tools: shippedTools, rapid: 10_000, tracing: traceStock };

describe("every program of the folder", () => {
  test.each(programs)("%s is printed as it was read, and moves as before", async (path, text) => {
    const program = parse(text);
    expect(print(program)).toBe(text);
    await expect(listing(run(program, shop))).toMatchFileSnapshot(path.replace(/\.h$/, ".moves"));
  });
});

describe("broken programs report what their first line expects", () => {
  test.each(broken)("%s", (_, text) => {
    const expected = /^; expect: (.*)$/m.exec(text)?.[1] ?? "";
    const program = parse(text);
    expect(print(program)).toBe(text);
    const said = run(program, shop).issues.map((f) => `${f.issue.code}@${f.line ?? 0}`);
    expect(said).toEqual(expect.arrayContaining(expected.split(" ")));
    expect(issuesOf(program).every((i) => i.line > 0)).toBe(true);
  });
});

/** Programs with pieces copied, dropped, swapped or with changed numbers. */
const damaged = fc
  .tuple(
    fc.constantFrom(...programs.map(([, text]) => text)),
    fc.array(
      fc.tuple(
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.nat(30),
        fc.constantFrom(
          "",
          "0",
          "-",
          "9",
          "99999",
          ".",
          "Q1",
          "\n",
          "~",
          "L X+1\n",
          "CALL LBL 2 REP 5\n",
          "RND R3\n",
          "LBL 2\n",
          "M99\n",
          "CYCL CALL\n",
          "TOOL CALL 8\n",
          "INCH",
          "M137\n",
          "CR X+10 Z-3 R-4 DR+\n",
        ),
      ),
      { maxLength: 6 },
    ),
  )
  .map(([text, edits]) =>
    edits.reduce((t, [where, drop, put]) => {
      const at = Math.floor(where * t.length);
      return t.slice(0, at) + put + t.slice(at + drop);
    }, text),
  );

test("no program makes the run throw, and no number of a report is NaN", () => {
  fc.assert(
    fc.property(damaged, (text) => {
      const program = parse(text);
      const done = run(program, shop);
      const simulation = simulate(done);
      const made = report(
        { file: "x.h", run: done, simulation, milliseconds: { parse: 0, plan: 0, simulate: 0 } },
        "en",
      );
      const numbers = JSON.stringify(made, (_, value: unknown) => {
        if (typeof value === "number" && !Number.isFinite(value)) throw new Error(`not finite in ${text}`);
        return value;
      });
      expect(numbers).toContain("turnwise-report/1");
    }),
    { numRuns: 300 },
  );
});
