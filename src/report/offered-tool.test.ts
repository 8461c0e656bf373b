import { expect, test } from "vitest";
import { cycleByNumber } from "../cycles/index.ts";
import { ncLabels } from "../i18n/nc-labels.ts";
import { parse } from "../nc/parse.ts";
import { exampleJob } from "../program/job/job.ts";
import { printJob } from "../program/job/print-job.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { report } from "./report.ts";

const issuesWith = (change: Readonly<Record<string, string>>, tools = shippedTools) => {
  const job = exampleJob(cycleByNumber(812) as never);
  const ran = run(parse(printJob({ ...job, drafts: { 812: { ...job.drafts[812], ...change } } }, ncLabels("en"))), {
    tools: shippedTools,
    rapid: 10_000,
  });
  const checked = {
    file: "t.h",
    run: ran,
    simulation: simulate(ran),
    milliseconds: { parse: 0, plan: 0, simulate: 0 },
    tools,
  };
  return report(checked, "en").issues;
};

test("a corner too sharp for the insert keeps its radius, and the tool that makes it is named", () => {
  const found = issuesWith({ Q500: "0.4" }).find(({ code }) => code === "cornerSmallerThanInsert");
  expect(found?.data).not.toHaveProperty("nearest");
  const { otherTool } = (found?.data ?? {}) as { otherTool?: number };
  const tool = shippedTools.find(({ T }) => T === otherTool);
  expect(tool?.RS).toBeLessThanOrEqual(0.4);
  expect(found?.text).toContain(`Tool ${otherTool} ${tool?.NAME} is suitable for this contour.`);
});

test("where no tool of the table makes it none is named", () => {
  const found = issuesWith({ Q500: "0.05" }).find(({ code }) => code === "cornerSmallerThanInsert");
  expect(found?.data).not.toHaveProperty("otherTool");
});
