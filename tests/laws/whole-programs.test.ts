import fc from "fast-check";
import { expect, test } from "vitest";
import { parse } from "../../src/nc/parse.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { cutEnds } from "../../src/sim/work-holding.ts";
import { stockIssues } from "../../src/sim/issues.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { areaOf, beyondGrown, filled } from "../judge/field.ts";
import { gridOver, judge, THIN } from "../judge/judge.ts";
import { EXPECTED_CODE, wholePrograms } from "./whole-programs.ts";

const CASES = Number(process.env["LAW_CASES"] ?? 6);
/** Column width, mm, and the area in which both judges may differ, mm². */
const [WIDTH, SAME] = [0.05, 0.1];
const MEANT = [
  "gouge",
  "rapidInStock",
  "holderContact",
  "cutOnLoosePiece",
  "behindBlank",
  "cutBelowContour",
  "cameLoose",
  "nothingCut",
];

test("whole programs: intended cuts have no finding, a planted fault has its own, and the columns leave the same stock", () => {
  fc.assert(
    fc.property(wholePrograms, ({ text, planted, parts }) => {
      const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
      const simulation = simulate(made);
      const codes = stockIssues(simulation).map(({ issue }) => issue.code as string);
      expect(made.issues.filter(({ issue }) => issue.severity === "error")).toEqual([]);
      expect(codes.filter((code) => code === "partedOff")).toHaveLength(parts);
      const told = codes.filter((code) => MEANT.includes(code));
      if (planted === null) expect(told).toEqual([]);
      else expect(told).toContain(EXPECTED_CODE[planted]);
      const ends = (motion: number) => cutEnds(made.steps, motion + 1);
      const beyond = (["z", "r"] as const).map((along) => {
        const grid = gridOver(made.blank, along, WIDTH);
        const { final } = judge(made.blank, made.steps, [], grid, ends);
        const ours = filled(grid, simulation.final);
        const apart = (a: typeof ours, b: typeof ours) => areaOf(grid, beyondGrown(a, b, THIN));
        return [apart(final, ours), apart(ours, final)] as const;
      });
      expect(Math.min(...beyond.map(([more]) => more))).toBeLessThan(SAME);
      expect(Math.min(...beyond.map(([, less]) => less))).toBeLessThan(SAME);
    }),
    { numRuns: CASES },
  );
});
