import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import { issuesOf, print } from "../src/nc/program.ts";
import { printAsInManual, printJob } from "../src/program/job/print-job.ts";
import { readDraft } from "../src/program/job/read-draft.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { typedJobs } from "./control-file-texts.ts";

const shop = { tools: shippedTools, rapid: 10_000 };

describe("whatever is typed", () => {
  test("all layouts have the same content, and the text is read as intended", () => {
    fc.assert(
      fc.property(typedJobs, (job) => {
        const cycle = cuttingCycles.find((c) => c.number === job.cycle);
        const [old, recent] = (["tnc640", "tnc7"] as const).map((layout) =>
          printJob({ ...job, layout }, ncLabels(job.ncLanguage)),
        );
        const [a, b] = [old, recent].map((text) => parse(text ?? ""));
        if (!a || !b || !cycle) throw new Error("no program");
        expect(print(a)).toBe(old);
        const said = [b, parse(printAsInManual(job, ncLabels(job.ncLanguage)))];
        for (const other of said)
          expect(other.blocks.map((x) => x.statement)).toEqual(a.blocks.map((x) => x.statement));
        expect(issuesOf(a).filter((i) => i.severity !== "error")).toEqual([]);
        const [first, second] = [a, b].map((p) => run(p, shop));
        expect(first?.steps).toEqual(second?.steps);
        const { values } = readDraft(cycle, job.drafts[cycle.number] ?? {}, { Q5: 0 });
        const typedParameter = Object.values(job.drafts[cycle.number] ?? {}).includes("Q5");
        if (values && !typedParameter)
          expect(first?.issues.filter((f) => ["missing", "notAChoice", "notANumber"].includes(f.issue.code))).toEqual(
            [],
          );
      }),
      { numRuns: 150 },
    );
  });
});
