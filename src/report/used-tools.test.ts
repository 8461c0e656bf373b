import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { readList, rowsCalled, shippedList, type ToolList } from "../program/tools/tool-list.ts";
import { simulate } from "../sim/simulate.ts";
import { traceStock } from "../sim/tracing.ts";
import { report, type Report } from "./report.ts";
import { usedTools } from "./used-tools.ts";

const NO_TIME = { parse: 0, plan: 0, simulate: 0 };

function reportWith(text: string, list: ToolList): Report {
  const { table } = readList(list);
  const made = run(parse(text), { ...table, rapid: 10_000, control: "TNC 640", tracing: traceStock });
  return report(
    { file: "A.h", run: made, simulation: simulate(made), milliseconds: NO_TIME, tools: table.tools },
    "en",
  );
}
const changed = (number: number, cells: object): ToolList =>
  shippedList.map((entry) =>
    entry.cells.T === String(number) ? { ...entry, cells: { ...entry.cells, ...cells } } : entry,
  );

/** A report without the tools of the table that it suggests. */
function provenIn({ proof, issues, operations, ...report }: Report): string {
  const bare = (found: Report["issues"]) =>
    found.filter(({ code }) => code !== "betterTool").map(({ data: _, text: __, ...issue }) => issue);
  return JSON.stringify({
    ...report,
    proof: { ...proof, residual: proof.residual.map(({ tools: _, ...piece }) => piece) },
    operations: operations.map((o) => ({ ...o, issues: bare(o.issues) })),
    issues: bare(issues),
  });
}

/** The same path, stock and verdict with the used tools alone. */
function expectSame(text: string, list: ToolList): ToolList {
  const whole = reportWith(text, list);
  const used = rowsCalled(list, usedTools([parse(text)], whole));
  expect(provenIn(reportWith(text, used))).toBe(provenIn(whole));
  return used;
}

const examples = readdirSync("src/examples").filter((name) => name.endsWith(".h"));
test.each(examples)("%s gives the same report with only the tools it uses", (name) => {
  const text = readFileSync(`src/examples/${name}`, "utf8");
  const used = expectSame(text, shippedList);
  expect(used.length).toBeLessThan(shippedList.length);
  expectSame(text, changed(3, { RS: "3" }));
  expectSame(text, changed(1, { RS: "2,37", CUTLENGTH: "1.9" }));
});

const part = (call: string) =>
  `BEGIN PGM S MM\nBLK FORM CYLINDER Z D63.4 L90 DIST+0\nFUNCTION MODE TURN\n${call}\n` +
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500\nM136\n" +
  "L X+95 Z+52 R0 FMAX\nL X+63.4 Z+1.8 FMAX M303\n" +
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~\nQ215=+0 ~\nQ460=+2 ~\nQ493=+41.27 ~\nQ494=-33.85 ~\nQ463=+2.35 ~\nQ478=+0.3 ~\nQ483=+0.5 ~\n" +
  "Q484=+0.15 ~\nQ505=+0.2 ~\nQ506=+0\nCYCL CALL\nM30\nEND PGM S MM\n";

test("a tool called by name, with an index, or not at all is included; a missing one stays missing", () => {
  const numbersOf = (list: ToolList) => list.map(({ cells }) => cells.T);
  const named = shippedList.find(({ cells }) => cells.T === "3")?.cells.NAME ?? "";
  expect(numbersOf(expectSame(part(`TOOL CALL "${named}"`), shippedList))).toContain("3");
  expect(numbersOf(expectSame(part(`TOOL CALL "${named.toLowerCase()}"`), shippedList))).toContain("3");
  expect(numbersOf(expectSame(part("TOOL CALL 3.2"), shippedList))).toContain("3");
  expect(reportWith(part("TOOL CALL 97"), shippedList).issues.map(({ code }) => code)).toContain("toolUnknown");
  expect(numbersOf(expectSame(part("TOOL CALL 97"), shippedList))).not.toContain("97");
  // The operation has the tool used in place of a missing one.
  expect(expectSame(part(";no tool"), shippedList).length).toBeGreaterThan(0);
});

test("a tool with invalid columns is included unchanged, and refused for the same reason", () => {
  const list = changed(3, { RS: "-1" });
  expect(expectSame(part("TOOL CALL 3"), list).map(({ cells }) => cells.RS)).toContain("-1");
  expect(reportWith(part("TOOL CALL 3"), list).issues.map(({ code }) => code)).toContain("toolColumn");
});

test("tools that would remove residual material are not called, so they are left out", () => {
  const list = changed(3, { RS: "3" });
  const used = expectSame(part("TOOL CALL 3"), list);
  const named = reportWith(part("TOOL CALL 3"), list).proof.residual.flatMap(({ tools }) => tools);
  expect(named.length).toBeGreaterThan(0);
  expect(used.map(({ cells }) => Number(cells.T))).toEqual([3]);
});

test("where the program computes a call, every tool is included", () => {
  const text = part("Q7 = 3\nTOOL CALL Q7");
  expect(usedTools([parse(text)], reportWith(text, shippedList))).toBeNull();
  expect(rowsCalled(shippedList, null)).toEqual(shippedList);
});
