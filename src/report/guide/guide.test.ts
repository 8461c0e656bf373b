import { expect, test } from "vitest";
import { activeSteps } from "../../cycles/active-steps.ts";
import { catalogue, cycleByNumber } from "../../cycles/index.ts";
import type { SomeValues } from "../../cycles/effect.ts";
import type { Cycle } from "../../cycles/define.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { never } from "../../kernel/never.ts";
import { parse } from "../../nc/parse.ts";
import { exampleJob } from "../../program/job/job.ts";
import { printJob } from "../../program/job/print-job.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { pieceTime } from "./piece-time.ts";
import { shownBox, shownChange, shownEffect, type RanProgram } from "./shown-effect.ts";
import { stepPieces } from "./step-pieces.ts";
import { neededFor, threeValues } from "./three-values.ts";

const cycle = (number: number): Cycle => cycleByNumber(number) ?? never("no such cycle", number);

function ran(number: number, values: Readonly<Record<string, string>> = {}): RanProgram {
  const job = exampleJob(cycle(number));
  const drafts = { [number]: { ...job.drafts[number], ...values } };
  const made = run(parse(printJob({ ...job, drafts }, ncLabels("en"))), { tools: shippedTools, rapid: 9700 });
  return { run: made, simulation: simulate(made) };
}

const shown = (number: number, q: string, values: SomeValues) =>
  threeValues(cycle(number), q, values).map(({ tried, isUsual }) => (isUsual ? `[${tried.join()}]` : String(tried[0])));

test("a small, the usual and a large value of each kind", () => {
  expect(shown(812, "Q463", { Q463: 2.7 })).toEqual(["0.9", "[2.7]", "5.4"]);
  expect(shown(812, "Q478", { Q478: "auto" })).toEqual(["0.1", "[auto]", "0.5"]);
  expect(shown(812, "Q493", { Q491: 73, Q493: 48 })).toEqual(["38", "[48]", "58"]);
  expect(shown(812, "Q494", { Q492: 0, Q494: -37.5 })).toEqual(["-22.5", "[-37.5]", "-52.5"]);
  expect(shown(812, "Q496", { Q496: 0 })).toEqual(["[0]", "5", "15"]);
  expect(shown(820, "Q482", { Q482: 0 })).toEqual(["-4", "[0]", "4"]);
  expect(shown(812, "Q506", { Q506: 1 })).toEqual(["0", "[1]", "2"]);
  expect(shown(861, "Q510", { Q510: 0.9 })).toEqual(["0.45", "[0.9]", "0.99"]);
});

test("values without an effect of their own get the values they need, and oversizes are shown before finishing", () => {
  expect(neededFor(cycle(812), "Q504", { Q503: 0, Q504: 0.3, Q215: 0 })).toEqual({ Q503: 1 });
  expect(neededFor(cycle(812), "Q504", { Q503: 2, Q504: 0.3, Q215: 0 })).toEqual({});
  expect(neededFor(cycle(820), "Q480", { Q479: 0, Q480: 31, Q215: 0 })).toEqual({ Q479: 1 });
  expect(neededFor(cycle(820), "Q483", { Q483: 0.7, Q215: 0 })).toEqual({ Q215: 1 });
});

test("what a deeper infeed changes, in the numbers of the runs", () => {
  const [usual, deep] = [ran(812), ran(812, { Q463: "5.1" })];
  const change = shownChange(deep, usual);
  expect(change.passes).toBe(shownEffect(deep).passes - shownEffect(usual).passes);
  expect(change.passes).toBe(-2);
  expect(change.seconds).toBeLessThan(-15);
  expect(change.part).toBeLessThan(0.005);
  expect(change.rz).toBeCloseTo(0, 6);
});

test("the effect of a corner radius is shown close up, and the nose radius gives the roughness", () => {
  const [usual, round] = [ran(812), ran(812, { Q500: "5.3" })];
  // A fillet of r leaves (1 − π/4)·r² in a right corner; here the surface slopes by 5 degrees.
  expect(shownChange(round, usual).part).toBeGreaterThan(0.8 * (1 - Math.PI / 4) * (5.3 ** 2 - 1.5 ** 2));
  const near = shownBox([usual, round]),
    far = shownBox([usual, ran(812, { Q463: "1.3" })]);
  expect(near.right - near.left).toBeLessThan((far.right - far.left) / 4);
  expect(shownEffect(ran(812, { Q505: "0.17" })).rz).toBeCloseTo((1000 * 0.17 ** 2) / (8 * 0.8), 2);
});

test("each numbered step has its stretch, and the repeating step all further rounds", () => {
  const { steps } = ran(812).run;
  const pieces = stepPieces(cycle(812), steps, 0);
  expect(pieces.map(({ run: of, number, piece }) => `${of[0]}${number}${piece ? "" : "-"}`).join(" ")).toBe(
    "r1 r2 r3 r4 r5 r6 f1 f2 f3 f4",
  );
  for (const { run: of, number, piece } of pieces) {
    const moves = steps.slice(piece?.from, piece?.to).map(({ move }) => move);
    if (of === "rough" && number === 5) expect(new Set(moves.map(({ pass }) => pass)).size).toBeGreaterThan(3);
    else expect(moves.every((move) => move.run === of && move.step === number)).toBe(true);
  }
  expect(pieces.map(({ piece }) => piece?.from ?? -1)).toEqual(
    pieces.map(({ piece }) => piece?.from ?? -1).toSorted((a, b) => a - b),
  );
  expect(
    stepPieces(cycle(852), ran(852).run.steps, 0)
      .filter(({ piece }) => !piece)
      .map(({ number }) => number),
  ).toEqual([3, 4, 5, 6]);
});

test("a stretch begins at its first move, ends after its last one and never goes back", () => {
  const { steps } = ran(820).run;
  for (const { piece } of stepPieces(cycle(820), steps, 0)) {
    if (!piece) continue;
    const time = pieceTime(steps, piece);
    const places = Array.from({ length: 24 }, (_, i) => time.at((i * time.lasts) / 23)).map(
      ({ step, fraction }) => step + fraction,
    );
    expect(places[0]).toBe(piece.from);
    expect(places.at(-1)).toBe(piece.to);
    expect(places).toEqual(places.toSorted((a, b) => a - b));
  }
});

test("a step in which a value acts is one of its cycle, and every value that is not reserved acts somewhere", () => {
  const wrong = catalogue.flatMap((each) =>
    Object.entries(each.params).flatMap(([q, param]) => {
      const { rough, finish } = activeSteps(each, param);
      const beyond = [...rough.map((n) => n > each.steps.rough), ...finish.map((n) => n > each.steps.finish)].some(
        Boolean,
      );
      return beyond || (!each.acts && !param.reserved && rough.length + finish.length === 0)
        ? [`${each.number} ${q}`]
        : [];
    }),
  );
  expect(wrong).toEqual([]);
});
