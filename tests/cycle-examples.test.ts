import { describe, expect, test } from "vitest";
import { verified } from "../scripts/verify.ts";
import { cuttingCycles } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { NC_LANGUAGES } from "../src/nc/nc-languages.ts";
import { parse } from "../src/nc/parse.ts";
import { issuesOf, print } from "../src/nc/program.ts";
import { exampleJob } from "../src/program/job/job.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

/* The example of every cycle as a new program starts with it: a user's first program with a cycle must be proved. */
const cutting = cuttingCycles;
const tools = { tools: shippedTools, refused: new Map() };

describe.each(cutting.map((cycle) => [cycle.number, cycle] as const))("the example of cycle %i", (number, cycle) => {
  test.each(["tnc640", "tnc7"] as const)(
    "comes back to the byte in the layout of %s, in every label language",
    (layout) => {
      for (const ncLanguage of NC_LANGUAGES) {
        const text = printJob({ ...exampleJob(cycle), layout, ncLanguage }, ncLabels(ncLanguage));
        const program = parse(text);
        expect(print(program)).toBe(text);
        expect(issuesOf(program)).toEqual([]);
      }
    },
  );

  test("runs with its tool from its start point, without contour damage, and is proved", () => {
    const text = printJob(exampleJob(cycle), ncLabels("en"));
    const { operations } = run(parse(text), { tools: shippedTools, rapid: 10_000 });
    expect(operations.map((o) => [o.cycle, o.tool.T])).toEqual([[number, cycle.setup.tool]]);
    expect(operations[0]?.plan.moves.length).toBeGreaterThan(5);
    expect(operations[0]?.plan.moves.length).toBeLessThan(20_000);
    const { issues, proof } = verified("example.h", text, tools);
    expect(issues.filter((i) => i.severity === "error")).toEqual([]);
    expect(proof).toMatchObject({ verdict: "proved", gouge: 0, rapidInStock: 0 });
  });
});

/** Cycles whose contour has a square corner, where a round nose leaves material. */
const SQUARE = [811, 813, 821, 823];
/** Unavoidable findings of an example: a taper is cut from a cylinder, since a set-up has no other blank. */
const EXPECTED_FINDINGS: Readonly<Record<number, readonly string[]>> = {
  832: ["deeperThanInfeed", "materialLeft", "threadMeets"],
};

test.each(cutting.map((cycle) => [cycle.number, cycle] as const))(
  "the example of cycle %i opens with no warning that can be helped",
  (number, cycle) => {
    const { issues } = verified("example.h", printJob(exampleJob(cycle), ncLabels("en")), tools);
    const told = new Set(issues.filter((i) => i.severity !== "info").map((i) => i.code));
    expect([...told].toSorted()).toEqual(EXPECTED_FINDINGS[number] ?? []);
  },
);

test.each(SQUARE)(
  "the example of the simple shoulder %i leaves what a round nose leaves in a square corner, and no more",
  (number) => {
    const cycle = cutting.find((c) => c.number === number) as (typeof cutting)[number];
    const { proof, operations } = verified("example.h", printJob(exampleJob(cycle), ncLabels("en")), tools);
    const nose = Number(operations[0]?.tool["RS"]);
    expect(proof.residual.map((left) => left.reason)).toEqual(["insertRadius"]);
    // The simulation uses chords with an error of half a micron.
    expect(Math.abs((proof.residual[0]?.area ?? NaN) - (1 - Math.PI / 4) * nose ** 2)).toBeLessThan(0.002);
  },
);
