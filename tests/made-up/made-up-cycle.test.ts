import fc from "fast-check";
import { describe, expect, test, vi } from "vitest";
import type { Cycle } from "../../src/cycles/define.ts";
import { cycleByNumber } from "../../src/cycles/index.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { toDiameter } from "../../src/kernel/units.ts";
import { parse } from "../../src/nc/parse.ts";
import { exampleJob } from "../../src/program/job/job.ts";
import { printJob } from "../../src/program/job/print-job.ts";
import { exampleDraft, readDraft } from "../../src/program/job/read-draft.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { verified } from "../../scripts/verify.ts";
import { exampleOf, pictured } from "../help/drawings.ts";
import { brokenBy } from "../laws/cut-laws.ts";
import { drawnFrom } from "../laws/situation.ts";
import { c899, setups899 } from "./c899.ts";

/*
 * A cycle is one file and one line of the index: this one is in neither the texts nor the tests, and everything works
 * with it.
 */
vi.mock("../../src/cycles/index.ts", async (original) => {
  const index = await original<{ readonly catalogue: readonly Cycle[] }>();
  const { c899 } = await import("./c899.ts");
  const catalogue = [...index.catalogue, c899 as unknown as Cycle];
  return { ...index, catalogue, cycleByNumber: (number: number) => catalogue.find((c) => c.number === number) };
});

const cycle = c899 as unknown as Cycle;
const text = printJob(exampleJob(cycle), ncLabels("en"));

describe("a made-up cycle", () => {
  test("has its prompts in the order of its file, and typed text becomes values", () => {
    expect(cycleByNumber(899)).toBe(cycle);
    const { values, issues } = readDraft(cycle, { ...exampleDraft(cycle), Q493: "51.25" });
    expect(issues).toEqual([]);
    expect(values).toMatchObject({ Q493: 51.25 });
    expect(readDraft(cycle, { ...exampleDraft(cycle), Q463: "0" }).issues.map((i) => i.code)).toEqual(["outOfRange"]);
  });

  test("is printed, read back, run and proved", () => {
    expect(text.match(/^ *Q\d+/gm)?.map((q) => q.trim())).toEqual(Object.keys(c899.params));
    const [operation] = run(parse(text), { tools: shippedTools, rapid: 10_000 }).operations;
    expect(operation?.cycle).toBe(899);
    expect(Math.min(...(operation?.plan.moves.map((m) => toDiameter(m.to.r)) ?? []))).toBeCloseTo(50, 9);
    const { proof } = verified("made-up.h", text, { tools: shippedTools, refused: new Map() });
    expect(proof).toMatchObject({ verdict: "proved", gouge: 0 });
  });

  test("has a help picture that dimensions its prompts", () => {
    for (const q of Object.keys(c899.params)) {
      const marks = pictured(cycle, exampleOf(cycle))?.(q, { width: 460, height: 300 }).marks ?? [];
      expect(marks.length).toBeGreaterThan(10);
      expect(JSON.stringify(marks)).not.toMatch(/NaN|null,null/);
    }
  });

  test("is checked against the laws by the set-ups of its file", () => {
    for (const operation of [0, 3])
      fc.assert(
        fc.property(drawnFrom(setups899, operation), (s) => {
          expect(brokenBy(cycle, s)).toEqual([]);
        }),
        { numRuns: 4 },
      );
  });
});
