import { describe, expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Step } from "../kernel/time/step.ts";
import { axial, length } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { areBoxesApart, snapshotSteps, sweptBox } from "./resume.ts";
import { incrementalSimulator, simulate } from "./simulate.ts";
import type { Simulation, SimulationInput } from "./simulation.ts";

/** Roughing, a plain cut below its contour, and finishing of the same shoulder. */
const input: SimulationInput = run(
  parse(
    [
      "BEGIN PGM S MM",
      "BLK FORM CYLINDER Z D60 L60 DIST+1",
      "FUNCTION MODE TURN",
      "TOOL CALL 1",
      "FUNCTION TURNDATA SPIN VCONST:OFF S700",
      "M136",
      "L X+70 Z+5 R0 FMAX M303",
      "CYCL DEF 811 SHOULDER ~\nQ215=+1 ~\nQ460=+2 ~\nQ493=+50 ~\nQ494=-20 ~\nQ463=+2 ~\nQ478=+0.3 ~\nQ483=+0.6 ~\nQ484=+0.4 ~\nQ505=+0.15 ~\nQ506=+0",
      "L X+62 Z+3 FMAX",
      "CYCL CALL",
      "L X+48 FMAX",
      "L Z-4 F0.2",
      "L X+64",
      "L Z+3 FMAX",
      "CYCL DEF 811 SHOULDER ~\nQ215=+2 ~\nQ460=+2 ~\nQ493=+50 ~\nQ494=-20 ~\nQ463=+2 ~\nQ478=+0.3 ~\nQ483=+0.6 ~\nQ484=+0.4 ~\nQ505=+0.15 ~\nQ506=+0",
      "L X+62 Z+3 FMAX",
      "CYCL CALL",
      "L X+62 Z-30 FMAX",
      "L X+55 F0.2",
      "L X+70",
      "M30",
      "END PGM S MM",
      "",
    ].join("\n"),
  ),
  { tools: shippedTools, rapid: 10_000 },
);
const lastStep = input.steps.length - 1;

const withPlan = (index: number, change: (plan: Plan) => Partial<Plan>): SimulationInput => ({
  ...input,
  operations: input.operations.map((o, i) => (i === index ? { ...o, plan: { ...o.plan, ...change(o.plan) } } : o)),
});
const withStep = (index: number, change: (step: Step) => Partial<Step>): SimulationInput => ({
  ...input,
  steps: input.steps.map((s, i) => (i === index ? { ...s, ...change(s) } : s)),
});
const grown = (rings: readonly Ring[], by: number): Ring[] =>
  rings.map((ring) => ring.map(({ z, r }) => at(z, r > 1 ? r + by : r)));
/** The same with other finished parts, and nothing of them machined. */
const withParts = (by: number): SimulationInput => ({
  ...input,
  operations: input.operations.map((o) => ({
    ...o,
    plan: { ...o.plan, area: [], part: grown([o.plan.part], by)[0] as Ring },
  })),
});
const firstCut = input.steps.findIndex(({ move }) => move.kind === "feed");

/** Every input that a simulation depends on; `kept`: the least share of the stocks before that are those of the run before. */
const CHANGES: readonly (readonly [what: string, changed: SimulationInput, kept: number])[] = [
  ["nothing", { ...input }, 1],
  ["equal steps that were made again", { ...input, steps: input.steps.map((s) => ({ ...s, move: { ...s.move } })) }, 1],
  ["the last step", withStep(lastStep, (s) => ({ move: { ...s.move, to: at(s.move.to.z, s.move.to.r + 1) } })), 0.8],
  ["the first cut", withStep(firstCut, (s) => ({ move: { ...s.move, to: at(s.move.to.z + 1, s.move.to.r) } })), 0],
  ["a step less at the end", { ...input, steps: input.steps.slice(0, -1) }, 0.8],
  ["a tool", withStep(firstCut, (s) => ({ tool: { ...s.tool, RS: length(0.2) } })), 0],
  ["the blank", { ...input, blank: grown(input.blank, 0.5) }, 0],
  ["the blank, where the same is held", { ...input, held: input.blank, blank: grown(input.blank, 0.5) }, 0],
  [
    "a blank that is stated later",
    { ...input, stated: [{ step: 12, block: 9, what: "BLK FORM", rings: grown(input.blank, -1) }] },
    0,
  ],
  ["the depth of the passes", withPlan(0, () => ({ maxInfeed: length(0.5) })), 0],
  ["the side that is open", withPlan(0, () => ({ openSide: at(1, 0) })), 0],
  ["a limit", withPlan(0, () => ({ limits: [{ at: "limit", axis: "z", value: axial(-9), behind: -1 } as never] })), 0],
  [
    "passes that follow the contour",
    withPlan(0, ({ isParallel }) => ({ isParallel: isParallel !== true }) as never),
    0,
  ],
  [
    "the operation of the last steps",
    { ...input, steps: input.steps.map((s) => (s.operation === 1 ? { ...s, operation: 0 } : s)) },
    0,
  ],
  ["a finished part that is smaller", withParts(-1.5), 0],
  ["a finished part that is larger", withParts(0.7), 0],
];

const kept = (before: Simulation, after: Simulation): number =>
  before.checkpoints.filter((mark, i) => mark.stock !== null && mark.stock === after.checkpoints[i]?.stock).length /
  before.checkpoints.filter(({ stock }) => stock !== null).length;

describe("a simulation that resumes where a run equals the one before", () => {
  test.each(CHANGES)("after a change of: %s", (_, changed, share) => {
    const again = incrementalSimulator();
    const before = again(input);
    const after = again(changed);
    const alone = simulate(changed);
    expect(after).toStrictEqual(alone);
    // A change that must not keep anything has another result.
    if (share === 0) expect(alone).not.toEqual(before);
    expect(kept(before, after)).toBeGreaterThanOrEqual(share);
    expect(again(input)).toStrictEqual(before);
  });
});

test("boxes are apart where a side of one lies beyond the other; touching ones are not", () => {
  const box = { left: -10, right: 0, low: 5, high: 9 };
  const beside = (own: Partial<typeof box>) => areBoxesApart(box, { ...box, ...own });
  expect(
    [
      { left: 0.1, right: 3 },
      { left: -20, right: -10.1 },
      { low: 9.1, high: 12 },
      { low: 0, high: 4.9 },
    ].map(beside),
  ).toEqual([true, true, true, true]);
  expect(
    [{ left: 0, right: 3 }, { left: -20, right: -10 }, { low: 9, high: 12 }, { low: 0, high: 5 }, {}].map(beside),
  ).toEqual([false, false, false, false, false]);
  expect(areBoxesApart({ ...box, left: 0.1, right: 3 }, box)).toBe(true);
});

test("the box of a step holds its outline along its way, with what is beyond the axis on this side", () => {
  const outline = [at(-1, -2), at(3, -2), at(3, 4), at(-1, 4)];
  const step = (from: readonly [number, number], to: readonly [number, number]) =>
    ({ from: at(...from), move: { kind: "feed", to: at(...to) } }) as unknown as Step;
  expect(sweptBox(outline, step([0, 30], [-20, 40]))).toEqual({ left: -21, right: 3, low: 28, high: 44 });
  expect(sweptBox(outline, step([0, 1], [0, -9]))).toEqual({ left: -1, right: 3, low: 0, high: 11 });
  expect(sweptBox(outline.slice(0, 2), step([0, 30], [-20, 40]))).toBeNull();
});

test("snapshots are at starts of operations and at even steps, never before the first step, and not too many", () => {
  const at20 = (count: number, ...starts: readonly number[]) => {
    const isKept = snapshotSteps({
      steps: { length: count },
      operations: starts.map((firstStep) => ({ firstStep })),
    } as unknown as SimulationInput);
    return Array.from({ length: count }, (_, i) => i).filter(isKept);
  };
  expect(at20(20, 0, 3, 13)).toEqual([3, 8, 13, 16]);
  expect(at20(4000).length).toBe(199);
  expect(at20(4000, 0, 7)[0]).toBe(7);
  // Of very many operations not every start.
  expect(at20(4000, ...Array.from({ length: 201 }, (_, i) => 3 * i)).length).toBe(199);
});
