import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { fewAlike, MOST_ALIKE } from "./alike.ts";
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
  const all = [...findings(MOST_ALIKE, "labelMissing"), ...findings(MOST_ALIKE, "toolUnknown")];
  expect(fewAlike(all)).toEqual(all);
});

test("of more, the first stay, and the number of the others stands where they begin", () => {
  const all = [...findings(MOST_ALIKE + 37, "labelMissing"), ...findings(3, "toolUnknown")];
  const few = fewAlike(all);
  expect(few.length).toBe(MOST_ALIKE + 1 + 3);
  expect(few[MOST_ALIKE]).toEqual({
    issue: { code: "moreAlike", severity: "error", data: { code: "labelMissing", count: 37 } },
    block: MOST_ALIKE,
    line: MOST_ALIKE + 1,
    operation: null,
  });
  expect(few.slice(0, MOST_ALIKE)).toEqual(all.slice(0, MOST_ALIKE));
});

test.each([
  ["info", MOST_ALIKE - 1],
  ["warning", MOST_ALIKE + 5],
  ["error", MOST_ALIKE + 9],
] as const)("what is left out is as grave as the gravest of it: %s", (severity, at) => {
  const few = fewAlike(findings(MOST_ALIKE + 20, "labelMissing", (i) => (i === at ? severity : "info")));
  expect(few[MOST_ALIKE]?.issue.severity).toBe(severity);
});

test("a program with a fault in every block lists some and counts the rest", () => {
  const blocks = Array.from({ length: 2500 }, (_, i) => `${i + 1} HEIDENHAIN what ever ${i}`);
  const { issues } = run(parse(["0 BEGIN PGM A MM", ...blocks, "2501 END PGM A MM", ""].join("\n")), {
    tools: [],
    rapid: 10_000,
  });
  expect(issues.filter((f) => f.issue.code === "notUnderstood").length).toBe(MOST_ALIKE);
  expect(issues.filter((f) => f.issue.code === "moreAlike").map((f) => f.issue.data)).toEqual([
    { code: "notUnderstood", count: 1500 },
    {
      code: "notProved",
      count: 1500,
    },
  ]);
});
