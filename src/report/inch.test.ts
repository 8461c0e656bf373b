import { expect, test } from "vitest";
import { cycleByNumber } from "../cycles/index.ts";
import { ncLabels } from "../i18n/nc-labels.ts";
import { parse } from "../nc/parse.ts";
import { exampleJob } from "../program/job/job.ts";
import { printJob } from "../program/job/print-job.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { report, type ReportIssue } from "./report.ts";

/** The issues of the example of a shoulder, in a program of a unit, with another value. */
function issuesOf(unit: "MM" | "INCH", q: string, mm: number): readonly ReportIssue[] {
  const job = exampleJob(cycleByNumber(812) as never),
    per = unit === "INCH" ? 25.4 : 1;
  const drafts = { 812: { ...job.drafts[812], [q]: String(mm) } };
  const text = printJob({ ...job, drafts }, ncLabels("en"));
  const isLength = (name: string) =>
    ["diameter", "axial", "length", "radial", "oversizeDiameter", "feed"].includes(
      cycleByNumber(812)?.params[name]?.kind ?? "",
    );
  const scaled = text
    .replace(" MM", ` ${unit}`)
    .replaceAll(" MM", ` ${unit}`)
    .replace(/(Q\d+)=([+-][\d.]+)/g, (all, name: string, value: string) =>
      isLength(name) ? `${name}=${Number(value) < 0 ? "" : "+"}${Number(value) / per}` : all,
    )
    .replace(
      /\b([XZDL]|DIST)([+-]?)(\d[\d.]*)/g,
      (_, word: string, sign: string, value: string) => `${word}${sign}${Number(value) / per}`,
    );
  const ran = run(parse(scaled), { tools: shippedTools, rapid: 10_000 });
  return report(
    { file: "t.h", run: ran, simulation: simulate(ran), milliseconds: { parse: 0, plan: 0, simulate: 0 } },
    "en",
  ).issues;
}

test.each([
  ["Q494", 55],
  ["Q500", 500],
  ["Q500", 0.4],
  ["Q463", 500],
])("in an inch program every length of an issue with %s=%d is in inches", (q, value) => {
  const of = (unit: "MM" | "INCH") => issuesOf(unit, q, value).filter(({ severity }) => severity !== "info");
  const [metric, inches] = [of("MM"), of("INCH")];
  expect(metric.length).toBeGreaterThan(0);
  expect(inches.map(({ code }) => code)).toEqual(metric.map(({ code }) => code));
  const numbers = ({ data }: ReportIssue) =>
    Object.entries(data ?? {}).filter(([name, n]) => typeof n === "number" && name !== "area") as [string, number][];
  metric.forEach((issue, i) => {
    const other = Object.fromEntries(numbers(inches[i] as ReportIssue));
    for (const [name, mm] of numbers(issue))
      expect([issue.code, name, other[name]]).toEqual([issue.code, name, expect.closeTo(mm / 25.4, 2)]);
  });
});
