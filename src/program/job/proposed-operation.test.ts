import { describe, expect, test } from "vitest";
import { catalogue, cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import { withOperation } from "../edits/added-operation.ts";
import { emptyProgram } from "./empty-program.ts";
import { operationsOf } from "../edits/operations.ts";
import { proposedOperation } from "./proposed-operation.ts";
import { readDraft } from "./read-draft.ts";
import { readRows } from "./contour-rows.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { tipAtCall } from "./requested-job.ts";
import { rankTools } from "../tools/which-tool.ts";

const runOf = (program: Program) => run(program, { tools: shippedTools, rapid: 10_000 });

/** Appends the proposal for a cycle to a program, with the best tool. */
function withProposed(program: Program, number: number): Program {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const { blank, operations } = runOf(program);
  const job = proposedOperation(cycle, { blank, before: operations });
  const { values } = readDraft(cycle, job.drafts[number] ?? {});
  if (!values) throw new Error(`${number}: values are missing`);
  const start = tipAtCall(job);
  const given = { start, contour: cycle.contour === "free" ? readRows(job.contour).contour.segments : null };
  const [best] = rankTools(
    cycle,
    values,
    given,
    { start, feedUnit: "mm/rev", autoFeed: null, stock: null },
    shippedTools,
  );
  const next = withOperation(program, { ...job, tool: best?.tool.T ?? 0 }, ncLabels("en"), {
    title: `CYCLE ${number}`,
  });
  return parse(print(next));
}

const begun = parse(emptyProgram("Part 7/b", { outside: "73.4", bore: "", length: "88.6", allowance: "1.3" }));
const cutting = catalogue.filter(({ acts }) => !acts).map(({ number }) => number);

describe("an inserted operation", () => {
  test("an empty program states its blank and runs to its end", () => {
    expect(print(begun)).toBe(
      "0 BEGIN PGM PART_7_B MM\n1 BLK FORM CYLINDER Z D73.4 L88.6 DIST+1.3\n2 FUNCTION MODE TURN\n3 M30\n4 END PGM PART_7_B MM\n".replaceAll(
        "PART_7_B",
        "Part_7_b",
      ),
    );
    expect(runOf(begun).issues).toEqual([]);
  });

  test.each(cutting)(
    "%i: cuts the blank that stands there, without an error, with its own blocks from comment to way back",
    (number) => {
      const program = withProposed(begun, number);
      const { operations, issues } = runOf(program);
      expect(issues.filter(({ issue }) => issue.severity === "error").map(({ issue }) => issue.code)).toEqual([]);
      expect(operations).toHaveLength(1);
      expect(operations[0]?.plan.moves.length).toBeGreaterThan(3);
      const { units } = operationsOf(program);
      expect(units.map(({ title, fixedReason }) => [title, fixedReason])).toEqual([[`CYCLE ${number}`, null]]);
    },
  );

  test("a shoulder goes on where the one before it ended", () => {
    const program = withProposed(withProposed(begun, 812), 812);
    const values = operationsOf(program).units.map(({ definitions: [index = 0] }) => {
      const s = program.blocks[index]?.statement;
      return s?.kind === "cycle" ? Object.fromEntries(s.parameters.map(({ q, value }) => [q, value])) : {};
    });
    expect(values[1]?.["Q492"]).toBe(values[0]?.["Q494"]);
    expect(values[0]?.["Q491"]).toBe(73.4);
    expect(Number(values[1]?.["Q494"])).toBeLessThan(Number(values[1]?.["Q492"]));
  });

  test("in the style of the file: its line ends, its count, its plus signs; M30 and turning where they are missing", () => {
    const cycle = cycleByNumber(812);
    if (!cycle) throw new Error("no cycle");
    const old = "10 BEGIN PGM A MM\r\n20 BLK FORM CYLINDER Z D60 L70\r\n30 END PGM A MM\r\n";
    const next = print(withOperation(parse(old), proposedOperation(cycle, { blank: [], before: [] }), ncLabels("en")));
    expect(
      next
        .split("\r\n")
        .filter((line) => /^\d/.test(line))
        .map((line) => /^(\d+) (\S+)/.exec(line)?.slice(1).join(" ")),
    ).toEqual([
      "10 BEGIN",
      "20 BLK",
      "30 FUNCTION",
      "40 TOOL",
      "50 FUNCTION",
      "60 M136",
      "70 L",
      "80 CYCL",
      "90 L",
      "100 CYCL",
      "110 L",
      "120 M305",
      "130 M30",
      "140 END",
    ]);
    expect(next).not.toMatch(/[^\r]\n/);
  });

  test("between two that share a tool: the second calls it again", () => {
    const twice =
      "0 BEGIN PGM A MM\n1 FUNCTION MODE TURN\n2 TOOL CALL 3\n3 FUNCTION TURNDATA SPIN VCONST:OFF S731\n4 M136\n" +
      "5 L X+90 Z+44 FMAX\n6 CYCL DEF 812 X ~\nQ215=+0\n7 L X+61 Z+2 FMAX M303\n8 CYCL CALL\n9 CYCL DEF 812 X ~\nQ215=+1\n" +
      "10 L X+62 Z+2 FMAX\n11 CYCL CALL\n12 L Z+44 FMAX\n13 M30\n14 END PGM A MM\n";
    const cycle = cycleByNumber(862);
    if (!cycle) throw new Error("no cycle");
    const job = { ...proposedOperation(cycle, { blank: [], before: [] }), tool: 10 };
    const next = parse(print(withOperation(parse(twice), job, ncLabels("en"), { behind: 0, title: "RECESS" })));
    const tools = operationsOf(next).units.map(({ toolCall }) =>
      next.blocks[toolCall ?? -1]?.raw.replace(/^\d+ /, "").trim(),
    );
    expect(tools).toEqual(["TOOL CALL 3", "TOOL CALL 10", "TOOL CALL 3"]);
    expect(print(next)).toMatch(
      /TOOL CALL 3\n\d+ FUNCTION TURNDATA SPIN VCONST:OFF S731\n\d+ M136\n\d+ L X\+90 Z\+44 FMAX\n\d+ M303\n\d+ CYCL DEF/,
    );
  });
});
