import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { limitPerCode, MOST_PER_CODE } from "./finding-limit.ts";
import { programIssue } from "./issue.ts";
import { run } from "../run/run.ts";
import type { RunFinding } from "./run-types.ts";

const findings = (
  count: number,
  code: "labelMissing" | "toolUnknown",
  severity: (i: number) => "error" | "warning" | "info" = () => "error",
): RunFinding[] =>
  Array.from({ length: count }, (_, i) => ({
    issue:
      code === "labelMissing"
        ? programIssue(code, severity(i), { label: String(i) })
        : programIssue(code, severity(i), { tool: String(i) }),
    block: i,
    line: i + 1,
    operation: null,
  }));

test("as many as are listed stay as they are", () => {
  const all = [...findings(MOST_PER_CODE, "labelMissing"), ...findings(MOST_PER_CODE, "toolUnknown")];
  expect(limitPerCode(all)).toEqual(all);
});

test("of more, the first stay, and the number of the others stands where they begin", () => {
  const all = [...findings(MOST_PER_CODE + 37, "labelMissing"), ...findings(3, "toolUnknown")];
  const few = limitPerCode(all);
  expect(few.length).toBe(MOST_PER_CODE + 1 + 3);
  expect(few[MOST_PER_CODE]).toEqual({
    issue: { code: "moreAlike", severity: "error", data: { code: "labelMissing", count: 37 } },
    block: MOST_PER_CODE,
    line: MOST_PER_CODE + 1,
    operation: null,
  });
  expect(few.slice(0, MOST_PER_CODE)).toEqual(all.slice(0, MOST_PER_CODE));
});

test.each([
  ["info", MOST_PER_CODE - 1],
  ["warning", MOST_PER_CODE + 5],
  ["error", MOST_PER_CODE + 9],
] as const)("what is left out is as grave as the gravest of it: %s", (severity, at) => {
  const few = limitPerCode(findings(MOST_PER_CODE + 20, "labelMissing", (i) => (i === at ? severity : "info")));
  expect(few[MOST_PER_CODE]?.issue.severity).toBe(severity);
});

test("a program with a fault in every block lists some and counts the rest", () => {
  const blocks = Array.from({ length: 2500 }, (_, i) => `${i + 1} HEIDENHAIN what ever ${i}`);
  const { issues } = run(parse(["0 BEGIN PGM A MM", ...blocks, "2501 END PGM A MM", ""].join("\n")), {
    tools: [],
    rapid: 10_000,
  });
  expect(issues.filter((f) => f.issue.code === "notUnderstood").length).toBe(MOST_PER_CODE);
  expect(issues.filter((f) => f.issue.code === "moreAlike").map((f) => f.issue.data)).toEqual([
    { code: "notUnderstood", count: 1500 },
    {
      code: "notProved",
      count: 1500,
    },
  ]);
});
