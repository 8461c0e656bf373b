import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../src/cycles/index.ts";
import type { Param } from "../src/cycles/params.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import { issuesOf, print } from "../src/nc/program.ts";
import { exampleJob, newRow, type SetJob } from "../src/program/job.ts";
import { printJob } from "../src/program/print-job.ts";
import { readDraft } from "../src/program/read-draft.ts";
import { run } from "../src/program/run.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";

const odd = fc.constantFrom("", "abc", "1e3", "--5", "Q5", "FAUTO", "0", "1/0", "99999999", "7,5", " 12 ", "75/2+1");
/** What may be typed into a field: usually a value of its range, sometimes anything. */
const typed = (p: Param) =>
  fc.oneof({
    weight: 8,
    arbitrary: p.choices
      ? fc.constantFrom(...p.choices.map(String))
      : fc.integer({ min: Math.ceil(Math.max(p.range[0], -90) * 1000), max: Math.floor(Math.min(p.range[1], 90) * 1000) }).map((n) =>
        String(n / 1000)
      ),
  }, { weight: 1, arbitrary: odd });
const length = fc.oneof({ weight: 6, arbitrary: fc.integer({ min: -60000, max: 90000 }).map((n) => String(n / 1000)) }, {
  weight: 1,
  arbitrary: odd,
});
const row = fc.record({
  id: fc.uuid(),
  kind: fc.constantFrom("L" as const, "RND" as const, "CHF" as const, "CR" as const, "CC" as const, "C" as const, "CT" as const),
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
}).map(({ id, ...given }) => newRow(id, given));
const jobs: fc.Arbitrary<SetJob> = fc.constantFrom(...cuttingCycles).chain((cycle) =>
  fc.record({
    draft: fc.record(Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, typed(p)]))),
    contour: fc.oneof(fc.constant(exampleJob(cycle).contour), fc.array(row, { maxLength: 8 })),
    start: fc.record({ x: length, z: length }),
    name: fc.oneof(fc.constant("PART"), fc.string({ maxLength: 12 })),
    parameters: fc.oneof(fc.constant({}), length.map((Q5) => ({ Q5 }))),
    ncLanguage: fc.constantFrom("en" as const, "de" as const, "fr" as const, "zh" as const),
    perRevolution: fc.boolean(),
  }).map(({ draft, ...rest }) => ({ ...exampleJob(cycle), drafts: { [cycle.number]: draft }, ...rest }))
);

const shop = { tools: shippedTools, rapid: 10_000 };

describe("whatever is typed", () => {
  test("both layouts say the same, and the text is read as it was meant", () => {
    fc.assert(fc.property(jobs, (job) => {
      const cycle = cuttingCycles.find((c) => c.number === job.cycle);
      const [old, recent] = (["tnc640", "tnc7"] as const).map((layout) => printJob({ ...job, layout }, ncLabels(job.ncLanguage)));
      const [a, b] = [old, recent].map((text) => parse(text ?? ""));
      if (!a || !b || !cycle) throw new Error("no program");
      expect(print(a)).toBe(old);
      expect(a.blocks.map((x) => x.statement)).toEqual(b.blocks.map((x) => x.statement));
      expect(issuesOf(a).filter((i) => i.severity !== "error")).toEqual([]);
      const [first, second] = [a, b].map((p) => run(p, shop));
      expect(first?.steps).toEqual(second?.steps);
      const { values } = readDraft(cycle, job.drafts[cycle.number] ?? {}, { Q5: 0 });
      const typedParameter = Object.values(job.drafts[cycle.number] ?? {}).includes("Q5");
      if (values && !typedParameter)
        expect(first?.issues.filter((f) => ["missing", "notAChoice", "notANumber"].includes(f.issue.code))).toEqual([]);
    }), { numRuns: 400 });
  });
});
