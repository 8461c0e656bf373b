import { describe, expect, test } from "vitest";
import { hasNoEffect } from "../../cycles/effect.ts";
import { catalogue, cycleByNumber } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import type { Site } from "../../cycles/shape-request.ts";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { simulate } from "../../sim/simulate.ts";
import { isOfDrawing } from "../values/suggestion.ts";
import { exampleJob, type SetJob } from "./job.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import { withOperation } from "../edits/added-operation.ts";
import { emptyProgram } from "./empty-program.ts";
import { operationsOf } from "../edits/operations.ts";
import { proposedOperation, sitesOf, usualSurface } from "./proposed-operation.ts";
import { readDraft } from "./read-draft.ts";
import { surfacesOf } from "./stock-surface.ts";
import { readRows } from "./contour-rows.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { tipAtCall } from "./requested-job.ts";
import { rankTools } from "../tools/which-tool.ts";

const runOf = (program: Program) => run(program, { tools: shippedTools, rapid: 10_000 });

const CONTOUR = [at(0.4, 21.3), at(-17.2, 21.3), at(-17.2, 33.1), at(-31.9, 33.1)];
const BORE = [at(0.4, 26.3), at(-17.2, 26.3), at(-17.2, 21.1), at(-31.9, 21.1)];
const chain = (points: readonly Pt[]) => points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
const cycleOf = (number: number) => {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  return cycle;
};

/** The proposal for a cycle behind the operations of a program. */
function proposalIn(program: Program, number: number, site: Site, start: SetJob["start"] = { x: "", z: "" }) {
  const cycle = cycleOf(number);
  const made = runOf(program);
  const stock = simulate(made).final;
  const surface = usualSurface(cycle, surfacesOf(stock, site));
  if (!surface) throw new Error(`${number}: no surface ${site}`);
  const along = cycle.group === "thread" ? [surface.from, surface.to] : site === "inside" ? BORE : CONTOUR;
  const contour = cycle.contour === "free" ? chain(along) : [];
  return proposedOperation(cycle, { stock, surface, before: made.operations, contour, start });
}

/** Appends an operation with its likely sizes and the best tool. */
function withLikely(program: Program, number: number, site: Site): Program {
  const cycle = cycleOf(number);
  const open = proposalIn(program, number, site).job.start;
  const { likely } = proposalIn(program, number, site, { x: open.x || "41.7", z: open.z || "-14.3" });
  const { values } = readDraft(cycle, likely.drafts[number] ?? {});
  if (!values) throw new Error(`${number}: values are missing`);
  const start = tipAtCall(likely);
  const given = { start, contour: cycle.contour === "free" ? readRows(likely.contour).contour.segments : null };
  const [best] = rankTools(
    cycle,
    values,
    given,
    { start, feedUnit: "mm/rev", autoFeed: null, stock: null },
    shippedTools,
  );
  const next = withOperation(program, { ...likely, tool: best?.tool.T ?? 0 }, ncLabels("en"), {
    title: `CYCLE ${number}`,
  });
  return parse(print(next));
}

const begun = parse(emptyProgram("Part 7/b", { outside: "73.4", bore: "", length: "88.6", allowance: "1.3" }));
const bored = parse(emptyProgram("B", { outside: "73.4", bore: "31.7", length: "88.6", allowance: "1.3" }));
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

  const places = cutting.flatMap((number) => sitesOf(cycleOf(number)).map((site) => [number, site] as const));

  test.each(places)("%i %s: with likely sizes it cuts the stock without an error", (number, site) => {
    const program = withLikely(site === "inside" ? bored : begun, number, site);
    const { operations, issues } = runOf(program);
    expect(issues.filter(({ issue }) => issue.severity === "error").map(({ issue }) => issue.code)).toEqual([]);
    expect(operations).toHaveLength(1);
    expect(operations[0]?.plan.moves.length).toBeGreaterThan(3);
    const { units } = operationsOf(program);
    expect(units.map(({ title, fixedReason }) => [title, fixedReason])).toEqual([[`CYCLE ${number}`, null]]);
  });

  test.each(places)("%i %s: no size of the drawing is written, and the run says so", (number, site) => {
    const cycle = cycleOf(number);
    const { job, placed } = proposalIn(site === "inside" ? bored : begun, number, site);
    const open = Object.entries<Param>(cycle.params).filter(
      ([q, p]) => isOfDrawing(p) && !hasNoEffect(p, {}) && placed[q] === undefined,
    );
    for (const [q] of open) expect([q, job.drafts[number]?.[q]]).toEqual([q, ""]);
    if (cycle.contour === "free") return;
    const program = withOperation(begun, { ...job, start: { x: "75.1", z: "3.2" } }, ncLabels("en"));
    const { issues, steps } = runOf(parse(print(program)));
    expect(issues.filter(({ issue }) => issue.code === "missing").length).toBeGreaterThan(0);
    expect(steps.filter(({ move }) => move.phase === "rough")).toEqual([]);
  });

  test.each([
    [812, "outside", { Q491: "73.4", Q492: "0" }, {}, { x: "73.4", z: "3.3" }],
    [811, "outside", {}, {}, { x: "73.4", z: "3.3" }],
    [812, "inside", { Q491: "31.7", Q492: "0" }, {}, { x: "31.7", z: "3.3" }],
    [822, "face", { Q491: "73.4", Q492: "1.3" }, { Q493: "29.7", Q494: "0" }, { x: "77.4", z: "1.3" }],
    [862, "outside", { Q491: "73.4" }, {}, { x: "77.4", z: "" }],
    [872, "face", { Q492: "1.3" }, {}, { x: "", z: "3.3" }],
    [831, "outside", { Q491: "73.4", Q492: "0" }, {}, { x: "83.4", z: "6.3" }],
    [831, "inside", { Q492: "0" }, {}, { x: "21.7", z: "6.3" }],
  ] as const)("%i %s: the surface gives the start, the stock suggests sizes", (number, site, placed, sizes, start) => {
    const made = proposalIn(bored, number, site);
    expect(made.placed).toEqual(placed);
    expect(made.sizes).toEqual(sizes);
    expect(made.job.start).toEqual(start);
    expect(made.job.drafts[number]).toMatchObject(placed);
  });

  test("a face of solid stock ends on the axis", () =>
    expect(proposalIn(begun, 822, "face").sizes).toMatchObject({ Q493: "0", Q494: "0" }));

  test("a thread is proposed on the front cylinder and ends in the relief behind it", () => {
    const turned = parse(
      "0 BEGIN PGM A MM\n1 BLK FORM CYLINDER Z D73.4 L88.6\n2 FUNCTION MODE TURN\n3 TOOL CALL 10\n" +
        "4 FUNCTION TURNDATA SPIN VCONST:OFF S731\n5 M136\n6 L X+90 Z+4 R0 FMAX M303\n7 L Z-21 FMAX\n8 L X+66 F0.1\n" +
        "9 L X+90 FMAX\n10 L Z-20 FMAX\n11 L X+66 F0.1\n12 L X+90 FMAX\n13 M30\n14 END PGM A MM\n",
    );
    const { placed, sizes, job } = proposalIn(turned, 831, "outside");
    expect(placed).toEqual({ Q491: "73.4", Q492: "0" });
    expect(sizes).toEqual({ Q494: "-19", Q474: "0" });
    expect(job.spindle).toMatchObject({ mode: "constant", speed: "520" });
  });

  test("in the style of the file: its line ends, its count, its plus signs; M30 and turning where they are missing", () => {
    const cycle = cycleByNumber(812);
    if (!cycle) throw new Error("no cycle");
    const old = "10 BEGIN PGM A MM\r\n20 BLK FORM CYLINDER Z D60 L70\r\n30 END PGM A MM\r\n";
    const next = print(withOperation(parse(old), exampleJob(cycle), ncLabels("en")));
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
    const job = { ...exampleJob(cycle), tool: 10 };
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
