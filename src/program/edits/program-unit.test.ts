import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { emptyProgram } from "../job/empty-program.ts";
import { exampleJob } from "../job/job.ts";
import { exampleDraft, readDraft } from "../job/read-draft.ts";
import { surfacesOf } from "../job/stock-surface.ts";
import { cylinder } from "../state/blank-form.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { radius } from "../../kernel/units.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { withHandOperation, withOperation } from "./added-operation.ts";
import { handCut, type HandWork } from "./hand-operation.ts";
import { draftForProgram, typedForProgram, typedInMillimetres } from "./program-unit.ts";

const shop = { tools: shippedTools, rapid: 10_000 };
const blank = { outside: "101.6", bore: "0", length: "76.2", allowance: "0" };
const metric = parse(emptyProgram("A", blank));
const inInches = parse(
  print(metric)
    .replace(/(BEGIN|END) PGM A MM/g, "$1 PGM A INCH")
    .replace(/BLK FORM .*/, "BLK FORM CYLINDER Z D4 L3 DIST+0"),
);

/** Resolution of an inch program, mm, for an end and the sizes it is computed from. */
const NEAR = 0.03;

const cornersOf = (ends: readonly Pt[]): Pt[] => {
  if (ends.length === 0) return [];
  const { left, right, low, high } = boxOf(ends);
  return [at(left, low), at(right, high)];
};

/** Moves outside cycles, corners of contours, and feeds of a run. A pass more or less by rounding does not matter. */
function movesOf(program: typeof metric) {
  const made = run(parse(print(program)), shop);
  const moves = made.steps.filter(({ operation }) => operation === null);
  const cutting = made.operations.flatMap(({ plan }) => plan.contour);
  expect(made.steps.length).toBeGreaterThan(1);
  const feeds = made.steps.flatMap(({ move }) => ("feed" in move && typeof move.feed === "number" ? move.feed : []));
  return {
    ends: [...moves.map(({ move }) => move.to), ...cornersOf(cutting.flatMap(({ from, to }) => [from, to]))],
    feeds: [Math.min(...feeds), Math.max(...feeds)],
  };
}

function expectSame(first: typeof metric, second: typeof metric) {
  const [mm, inch] = [movesOf(first), movesOf(second)];
  expect(inch.ends).toHaveLength(mm.ends.length);
  inch.ends.forEach((end, i) => {
    expect(Math.abs(end.z - (mm.ends[i]?.z ?? NaN))).toBeLessThan(NEAR);
    expect(Math.abs(end.r - (mm.ends[i]?.r ?? NaN))).toBeLessThan(NEAR);
  });
  inch.feeds.forEach((feed, i) => expect(feed).toBeCloseTo(mm.feeds[i] ?? NaN, 2));
}

describe.each(cuttingCycles.filter(({ contour }) => contour === "own").map((c) => [c.number, c] as const))(
  "cycle %i in an inch program",
  (_, cycle) => {
    test("its operation makes the moves of a program in mm", () => {
      const [first, second] = [metric, inInches].map((program) =>
        withOperation(program, exampleJob(cycle), ncLabels("en")),
      );
      if (first && second) expectSame(first, second);
    });

    test("its values are suggested in inches and read in mm", () => {
      const draft = exampleDraft(cycle);
      const typed = draftForProgram(cycle, draft, true);
      const [mm, read] = [readDraft(cycle, draft), readDraft(cycle, typed, {}, { perRevolution: true })];
      expect(read.issues).toEqual([]);
      for (const [q, value] of Object.entries(mm.partial))
        if (typeof value === "number") expect(read.partial[q]).toBeCloseTo(value, 2);
    });
  },
);

test.each(["chamfer", "partOff", "partOffChamfered", "drill"] as const)(
  "%s makes the moves of a program in mm",
  (work) => {
    const stock = cylinder({ outside: radius(50.8), inside: radius(0), length: 76.2, front: 0 }) ?? [];
    const [surface] = surfacesOf(stock, work === "drill" ? "face" : "outside");
    const wanted: Record<typeof work & HandWork, number> = { chamfer: 1, partOff: 9, partOffChamfered: 9, drill: 1 };
    const tool = shippedTools.find(({ T }) => T === wanted[work]);
    const [cycle] = cuttingCycles;
    if (!surface || !tool || !cycle) throw new Error("nothing to cut");
    const { start, cut } = handCut(work, { stock, surface, tool, sizes: { size: 2, z: -20 } });
    const job = { ...exampleJob(cycle), tool: tool.T, start, blank };
    expectSame(withHandOperation(metric, job, cut), withHandOperation(inInches, job, cut));
  },
);

test("a length is typed in the unit of the program, and a Q parameter stays", () => {
  expect(typedForProgram("-38.1", true)).toBe("-1.5");
  expect(typedInMillimetres("-1.5", true)).toBe("-38.1");
  for (const inches of [false, true])
    for (const text of ["", "Q5", "1x"]) {
      expect(typedForProgram(text, inches)).toBe(text);
      expect(typedInMillimetres(text, inches)).toBe(text);
    }
  expect(typedForProgram("-38.1", false)).toBe("-38.1");
});
