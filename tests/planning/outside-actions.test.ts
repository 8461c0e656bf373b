import { describe, expect, test } from "vitest";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { inBox } from "../../src/kernel/area/box.ts";
import { union } from "../../src/kernel/area/clip.ts";
import { at, part } from "../../src/kernel/geometry/point.ts";
import { degrees, length } from "../../src/kernel/units.ts";
import { parse } from "../../src/nc/parse.ts";
import { applyAction, withAction } from "../../src/planning/apply-action.ts";
import { actionSources } from "../../src/planning/actions/index.ts";
import { thread } from "../../src/planning/actions/thread.ts";
import { openRegions } from "../../src/planning/open-regions.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import type { ActionKind, PlannedPart, PlanRequest, PlanState, TriedAction } from "../../src/planning/types.ts";
import { emptyProgram } from "../../src/program/job/empty-program.ts";
import { cylinderAround } from "../../src/program/job/requested-shape.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { verdictOf } from "../../src/report/verdict.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { partOfTrade } from "./parts.ts";

/** Kinds of actions in the order of a simple plan; those of one step are compared with each other. */
const STEPS: readonly (readonly ActionKind[])[] = [
  ["face"],
  ["roughOutside"],
  ["restRough", "recess"],
  ["finishOutside"],
  ["undercut"],
  ["thread"],
  ["partOff"],
];
/** Actions that take less are not worth their time in this simple plan, mm². */
const LEAST = 0.09;

/** The working action that takes most; of equal ones the fastest. */
const best = (tried: readonly TriedAction[]): TriedAction | undefined =>
  tried
    .filter(({ works, cut, action }) => works && (cut > LEAST || action.threads.length > 0))
    .toSorted((a, b) => (Math.abs(b.cut - a.cut) > LEAST ? b.cut - a.cut : a.seconds - b.seconds))[0];

/** Applies the best action of each step until none works. */
function simplePlan(request: PlanRequest): PlanState {
  let state: PlanState = { stock: request.blank, done: [], threads: new Set() };
  for (const kinds of STEPS)
    for (let most = 6; most > 0; most -= 1) {
      const sources = actionSources.filter(({ kind }) => kinds.includes(kind));
      const actions = sources.flatMap((source) => source.actions(state, request));
      const found = best(actions.map((action) => applyAction(action, state, request)));
      if (!found) break;
      state = {
        stock: found.stock,
        done: [...state.done, found],
        threads: new Set([...state.threads, ...found.action.threads]),
      };
    }
  return state;
}

/** The program of all actions of a plan, in a row. */
function verdictOfPlan({ done }: PlanState, { blank, clamping, labels, shop }: PlanRequest) {
  const program = done.reduce(
    (made, { action }) => withAction(made, action, { labels, clamping }),
    parse(emptyProgram("PLAN", cylinderAround(blank))),
  );
  const made = run(program, shop);
  const simulation = simulate({ ...made, blank, clamping });
  return { verdict: verdictOf(made, simulation).verdict, gouge: simulation.proof.gouge };
}

const requestOf = (given: Pick<PlanRequest, "part" | "blank"> & Partial<PlanRequest>): PlanRequest => ({
  clamping: null,
  shop: { tools: shippedTools, rapid: 10_000 },
  material: "c45",
  rules: {
    toolChange: 5,
    usualTool: 0,
    finishBeforeRough: 60,
    insideBeforeOutside: 5,
    thinBeforeLong: 20,
    tolerancedLast: 20,
    allowance: { diameter: 0.5, z: 0.1 },
  },
  partsOff: false,
  withoutCycles: [],
  withoutTools: [],
  labels: ncLabels("en"),
  ...given,
});

/** A part by the corners of its outside, ⌀ and Z, from a bar. */
function turned(corners: readonly (readonly [x: number, z: number])[]): Pick<PlanRequest, "part" | "blank"> {
  const points = corners.map(([x, z]) => at(z, x / 2));
  const segments = points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
  const rear = points.at(-1)?.z ?? 0;
  const high = Math.max(...points.map(({ r }) => r)) + 1;
  const made: PlannedPart = {
    name: "TURNED",
    outside: { segments, marks: segments.map((_, i) => ({ row: `e${i}` })) },
    inside: { segments: [], marks: [] },
    rings: [[...points, at(rear, 0)].reverse()],
  };
  return { part: made, blank: [[at(rear - 40, 0), at(1, 0), at(1, high), at(rear - 40, high)]] };
}

function ofTrade(name: string): PlanRequest {
  const file = partOfTrade(name);
  const { part: planned, blank, clamping } = plannedPart(file);
  if (!planned) throw new Error(name);
  return requestOf({ part: planned, blank, clamping, material: file.material, partsOff: file.partsOff });
}

/** A finishing tool whose edge clears a face by 17.5°. */
const steep = shippedTools.map((tool) =>
  tool.T === 4 ? { ...tool, "T-ANGLE": degrees(107.5), RS: length(0.4) } : tool,
);

describe("a simple plan of actions outside", () => {
  const parts: readonly (readonly [string, PlanRequest, { readonly left: number; readonly threads: number }])[] = [
    [
      "steps with chamfers",
      requestOf(
        turned([
          [0, 0],
          [18, 0],
          [20, -1],
          [20, -25],
          [29, -25],
          [30, -25.5],
          [30, -50],
          [45, -50],
          [45, -60],
        ]),
      ),
      { left: 0, threads: 0 },
    ],
    [
      "a valley, and a groove that only a blade reaches",
      requestOf(
        turned([
          [0, 0],
          [30, 0],
          [30, -15],
          [24, -22],
          [24, -32],
          [40, -40],
          [40, -50],
          [34, -50],
          [34, -56],
          [40, -56],
          [40, -70],
        ]),
      ),
      { left: 0, threads: 0 },
    ],
    [
      "a groove in its face",
      requestOf(
        turned([
          [0, 0],
          [30, 0],
          [30, -4],
          [44, -4],
          [44, 0],
          [60, 0],
          [60, -20],
        ]),
      ),
      { left: 0, threads: 0 },
    ],
    ["shoulder bolt from bar: relief, thread, undercut, parted off", ofTrade("bolt"), { left: 0, threads: 1 }],
    // The edge of no shipped tool clears the face of form F.
    ["stepped shaft, undercut F left", ofTrade("shaft"), { left: 0.23, threads: 1 }],
    [
      "stepped shaft with a steep edge",
      { ...ofTrade("shaft"), shop: { tools: steep, rapid: 10_000 } },
      { left: 0, threads: 1 },
    ],
  ];
  test.each(parts)("%s", (_, request, expected) => {
    const state = simplePlan(request);
    const rear = Math.min(...request.part.outside.segments.map(({ to }) => to.z));
    const outside = inBox(state.stock, { left: rear, right: 1000, low: 0, high: 1000 });
    const left = openRegions(outside, request.part);
    expect({
      ...verdictOfPlan(state, request),
      threads: state.threads.size,
      left: Math.round(100 * left.reduce((sum, { area }) => sum + area, 0)) / 100,
    }).toEqual({ verdict: "proved", gouge: 0, ...expected });
  });
});

test("a taper thread with a shallow relief is cut along its cone", () => {
  const request = ofTrade("npt-fitting");
  const bar = [at(-70, 6.5), at(-36, 6.5), at(-36, 15), at(-70, 15)];
  const state = { stock: union(request.part.rings, [bar]), done: [], threads: new Set<string>() };
  const tried = thread.actions(state, request).map((action) => applyAction(action, state, request));
  expect(tried.map(({ works, gouge, action }) => ({ works, gouge, threads: action.threads }))).toEqual([
    { works: true, gouge: 0, threads: ["1/2 NPT -1.358"] },
  ]);
});
