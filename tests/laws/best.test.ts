import fc from "fast-check";
import { expect, test } from "vitest";
import type { Cycle } from "../../src/cycles/define.ts";
import { catalogue } from "../../src/cycles/index.ts";
import { contourFrom } from "../../src/kernel/contour/contour.ts";
import { at, part, type Pt } from "../../src/kernel/geometry/point.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { areaOf, each, without } from "../judge/field.ts";
import { insertOf } from "../judge/insert.ts";
import { gridOver, judge, sumOf } from "../judge/judge.ts";
import { least } from "../judge/least.ts";
import { drawnShape, everyForm, valleys, type Shape, type Site } from "./best-shapes.ts";
import type { Situation } from "./situation.ts";
import { planOf, stepsOf } from "./worked-plans.ts";

/* Compares the residual material of a programmed contour with the least possible, which is found without a strategy. */

/** Width of the columns, mm. Thinner areas, or those thinner than THIN, are not seen. */
const WIDTH = 0.04;
/** Allowed residual material above the least possible, mm². */
const OVER = 0.05;
/** Extent of the part and of its blank beyond the ends of a contour, mm. */
const ON = { part: 40, blank: 20 };

const cycleOf = (number: number) => catalogue.find((c) => c.number === number) as Cycle;

/**
 * Roughs and finishes a contour in one setting; returns the residual material above the least possible, and the contour
 * damage, mm².
 */
function worked(shape: Shape, { number, T, ...site }: Row, values: Readonly<Record<string, number>> = {}) {
  const built = contourFrom(shape.elements);
  expect(
    built.issues.filter((i) => i.severity === "error"),
    shape.name,
  ).toEqual([]);
  const points = part.flattenedChain(built.segments, 0.0005);
  const [first, last] = [points[0] as Pt, points.at(-1) as Pt];
  const { along, out } = site;
  const [across, height] = along === "z" ? (["z", "r"] as const) : (["r", "z"] as const);
  const place = (on: number, up: number): Pt => (along === "z" ? at(on, up) : at(up, on));
  const heights = points.map((p) => p[height]);
  const [top, low] =
    out > 0 ? [Math.max(...heights), Math.min(...heights)] : [Math.min(...heights), Math.max(...heights)];
  const deep = along === "z" && out > 0 ? 0 : low - out * 20;
  /** A shaft ends in front; the part with a recess continues there. */
  const front = (by: number) => first[across] + (site.closed ? by : 0);
  // Contours run towards −Z or to the axis.
  const beyond = (by: number) => last[across] - by;
  const ring = [
    ...(site.closed ? [place(front(ON.part), first[height])] : []),
    ...points,
    place(beyond(ON.part), last[height]),
    place(beyond(ON.part), deep),
    place(front(ON.part), deep),
  ];
  const [begin, end] = [front(ON.blank), beyond(ON.blank)];
  const start = place(first[across] + (site.closed ? 0 : 2), top + out);
  const cycle = cycleOf(number);
  const asked: Readonly<Record<string, number>> = {
    ...Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example as number])),
    Q463: 3.4,
    // All material over the contour of 815.
    Q485: Math.abs(top - low) + 1,
    ...values,
  };
  const s: Situation = {
    values: Object.fromEntries(Object.keys(cycle.params).map((q) => [q, asked[q] as number])),
    given: { contour: built.segments, start },
    tool: {
      ...(shippedTools.find((tool) => tool.T === T) as Tool),
      ...(site.closed && { CUTLENGTH: 90 as Tool["CUTLENGTH"] }),
    } as Tool,
    start,
    blank: [[place(begin, top), place(end, top), place(end, deep), place(begin, deep)]],
  };
  const plan = planOf(cycle, s);
  const errors = plan.issues.filter((i) => i.severity === "error").map((i) => i.code);
  const grid = gridOver([points], across, WIDTH);
  const stays = least(ring, insertOf(s.tool), site, grid, deep);
  const verdict = judge(s.blank, stepsOf([plan], s), [ring], grid);
  const over = areaOf(grid, each(verdict.final, stays, without));
  return { errors, over, gouge: sumOf(verdict, "gouge"), rapid: sumOf(verdict, "rapid") };
}

interface Row extends Site {
  readonly number: number;
  readonly T: number;
}
const shaft = { along: "z", out: 1, closed: false } as const;
const bore = { along: "z", out: -1, closed: false } as const;
const face = { along: "r", out: 1, closed: false } as const;
const recess = { closed: true } as const;

/** Every cycle of a programmed contour, with suitable tools. */
const ROWS: readonly Row[] = [
  { number: 810, T: 2, ...shaft },
  { number: 810, T: 3, ...shaft },
  { number: 810, T: 6, ...bore },
  { number: 815, T: 2, ...shaft },
  { number: 815, T: 6, ...bore },
  { number: 820, T: 15, ...face },
  { number: 840, T: 9, ...shaft, ...recess },
  { number: 840, T: 11, ...shaft, ...recess },
  { number: 840, T: 14, ...bore, ...recess },
  { number: 850, T: 8, ...face, ...recess },
  { number: 860, T: 10, ...shaft, ...recess },
  { number: 860, T: 11, ...shaft, ...recess },
  { number: 860, T: 14, ...bore, ...recess },
  { number: 870, T: 8, ...face, ...recess },
];
/** Number of drawn contours: a third of the machine's share of cases. */
const CASES = Math.ceil(Number(process.env["LAW_CASES"] ?? 6) / 3);

/** fast-check as a generator with a fixed seed: every run cuts the same contours. */
const shapes = (site: Row, seed: number): Shape[] =>
  fc.sample(
    fc.gen().map((g) =>
      drawnShape(
        {
          one: <T>(...of: readonly T[]) => of[g(fc.nat, { max: of.length - 1 })] as T,
          whole: (min, max) => g(fc.integer, { min, max }),
        },
        site,
      ),
    ),
    { numRuns: CASES, seed },
  );

test.each(ROWS)("$number with T$T leaves what cannot be taken ($out along $along)", (row) => {
  for (const [i, shape] of [everyForm(row), valleys(row), ...shapes(row, row.number + row.T)].entries()) {
    const { errors, over, ...faults } = worked(shape, row, { Q506: i % 3, Q486: i % 2, Q507: i % 2, Q562: i % 2 });
    expect.soft({ errors, over: over > OVER ? over : 0, ...faults }, `${i}: ${shape.name}`).toEqual({
      errors: [],
      over: 0,
      gouge: 0,
      rapid: 0,
    });
  }
});

test("roughing alone leaves more", () => {
  for (const row of ROWS.filter((r) => [3, 15, 9, 10].includes(r.T)))
    expect(worked(valleys(row), row, { Q215: 1 }).over, `${row.number}`).toBeGreaterThan(2);
});
