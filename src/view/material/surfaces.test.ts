import fc from "fast-check";
import { expect, test } from "vitest";
import flange from "../../examples/flange.h?raw";
import type { Move } from "../../kernel/plan/move.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, Step } from "../../kernel/time/step.ts";
import { feed, length } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { stockAt } from "../../sim/stock.ts";
import { feedLines, FEED_LINES, seenInside, seenOutside, turnsInside, turnsOutside } from "./lines.ts";
import { boundaryIn, columnsOf } from "./scan.ts";
import { surfacesOf, type StockSide } from "./surfaces.ts";

const tool = shippedTools[0] ?? expect.fail("there are tools");
const rough = { phase: "rough", run: "rough", step: 2, pass: 1 } as const,
  finish = { phase: "finish", run: "finish", step: 2 } as const;
const SPINDLE: Spindle = { kind: "constant", speed: 960 };
const BLANK: Ring = [at(-63.7, 0), at(0.8, 0), at(0.8, 25.3), at(-63.7, 25.3)];
const moves: readonly Move[] = [
  { kind: "rapid", to: at(2.3, 22.37), ...rough },
  { kind: "feed", to: at(-29.81, 22.37), feed: feed(0.31), feedUnit: "mm/rev", ...rough },
  { kind: "rapid", to: at(2.3, 26), ...rough },
  { kind: "rapid", to: at(2.3, 21.13), ...finish },
  { kind: "feed", to: at(-11.3, 21.13), feed: feed(120), feedUnit: "mm/min", ...finish },
];
const steps: Step[] = moves.map((move, i) => ({
  from: moves[i - 1]?.to ?? at(2.3, 26),
  move,
  tool,
  block: 3,
  operation: null,
  seconds: 1,
}));
const simulation = simulate({ blank: [BLANK], steps, operations: [], unproved: [] });
const done = { step: steps.length, fraction: 0 };

/** The looks of the level outsides of the stock, from left to right. */
function outside(now: { readonly step: number; readonly fraction: number }) {
  const surfaces = surfacesOf(steps, () => SPINDLE);
  const { edges } = boundaryIn(stockAt(simulation, now), surfaces, now, -1000, 1000);
  return edges
    .filter((e) => e.r0 === e.r1 && e.r0 > 0)
    .sort((a, b) => a.z0 - b.z0)
    .map((e) => [e.r0, e.made.texture, e.made.pitch]);
}

test("each level of the outside knows the move that made it, and its feed a turn", () => {
  expect(outside({ step: 0, fraction: 0 })).toEqual([[25.3, "raw", 0]]);
  expect(outside({ step: 2, fraction: 0 })).toEqual([
    [25.3, "raw", 0],
    [22.37, "rough", 0.31],
  ]);
  expect(outside(done)).toEqual([
    [25.3, "raw", 0],
    [22.37, "rough", 0.31],
    [21.13, "finished", 0.125],
  ]);
});

test("a running move has made the surface behind the tool and no more", () => {
  expect(outside({ step: 4, fraction: 0.5 })).toEqual([
    [25.3, "raw", 0],
    [22.37, "rough", 0.31],
    [21.13, "finished", 0.125],
  ]);
  expect(outside({ step: 4, fraction: 0.01 })).toEqual([
    [25.3, "raw", 0],
    [22.37, "rough", 0.31],
  ]);
});

test("a typed path block finishes if its feed and the nose leave little, with feeds per minute as per revolution", () => {
  // A nose of 0.8 mm leaves 10 µm at 0.2530 mm a turn; 960 turns a minute.
  const typed = { phase: "position", run: "rough", step: 0 } as const,
    side: StockSide = { z0: 0.8, r0: 22.37, z1: -29, r1: 22.37 };
  const look = (
    value: number,
    feedUnit: "mm/rev" | "mm/min",
    more: Partial<Step> = {},
    spindle: Spindle | null = SPINDLE,
  ) => {
    const move: Move = { kind: "feed", to: at(-29.81, 22.37), feed: feed(value), feedUnit, ...typed };
    const [first] = surfacesOf([{ ...(steps[1] as Step), move, ...more }], () => spindle).of(side, {
      step: 1,
      fraction: 0,
    });
    return first?.made.texture;
  };
  expect([look(0.2529, "mm/rev"), look(0.2531, "mm/rev")]).toEqual(["finished", "rough"]);
  expect([look(242.8, "mm/min"), look(243, "mm/min")]).toEqual(["finished", "rough"]);
  expect(look(100, "mm/min", {}, null)).toBe("rough");
  // Moves of a cycle other than its cuts finish nothing, however slow; nor does an edge without a nose.
  expect(look(0.1, "mm/rev", { operation: 0 })).toBe("rough");
  expect(look(0.1, "mm/rev", { tool: { ...tool, RS: length(0) } })).toBe("rough");
});

test("a side made by two moves is split where they meet", () => {
  const twice: Step[] = [
    steps[1],
    { ...(steps[4] as Step), move: { ...(moves[4] as Move), to: at(-11.3, 22.37) }, from: at(2.3, 22.37) },
  ].flatMap((s) => s ?? []);
  const side: StockSide = { z0: 0.8, r0: 22.37, z1: -29, r1: 22.37 };
  const [first, second, ...more] = surfacesOf(twice).of(side, { step: 2, fraction: 0 });
  expect([first?.made.step, second?.made.step, more.length]).toEqual([1, 0, 0]);
  expect(Math.abs(0.8 - (second?.begin ?? 0) * 29.8 + 11.3 - tool.RS)).toBeLessThan(0.1);
});

const example = run(parse(flange), { tools: shippedTools, rapid: 10_000 }),
  cut = simulate(example);
const moment = fc.record({
  step: fc.nat({ max: example.steps.length }),
  fraction: fc.constantFrom(0, 0.013, 0.41, 0.97),
});

test("earlier queries change no answer", () => {
  const asked = surfacesOf(example.steps);
  let sides = 0;
  fc.assert(
    fc.property(moment, (now) => {
      const rings = stockAt(cut, now),
        fresh = surfacesOf(example.steps);
      const [one, other] = [asked, fresh].map((s) =>
        boundaryIn(rings, s, now, -1000, 1000).edges.map((e) => e.made.step),
      );
      sides += one?.length ?? 0;
      expect(one).toEqual(other);
    }),
    { numRuns: 40 },
  );
  expect(sides).toBeGreaterThan(100);
});

test("a run that begins like another one, or is a part of it, has the same surfaces as on its own", () => {
  const { steps: all } = example,
    turned = all.map((step, i): Step => (i % 7 === 3 ? { ...step, operation: null } : step));
  let surfaces = surfacesOf(all),
    sides = 0;
  const prefix = fc.record({
    from: fc.constantFrom(all, turned),
    until: fc.integer({ min: 30, max: all.length }),
    speed: fc.constantFrom(960, 730),
  });
  fc.assert(
    fc.property(prefix, ({ from, until, speed }) => {
      const some = from.slice(0, until),
        spindleOf = (): Spindle => ({ kind: "constant", speed }),
        now = { step: until, fraction: 0 };
      const rings = stockAt(cut, now);
      surfaces = surfaces.forRun(some, spindleOf, () => false);
      const [one, other] = [surfaces, surfacesOf(some, spindleOf)].map((s) =>
        boundaryIn(rings, s, now, -1000, 1000).edges.map((e) => e.made),
      );
      sides += one?.length ?? 0;
      expect(one).toEqual(other);
    }),
    { numRuns: 60 },
  );
  expect(sides).toBeGreaterThan(100);
});

test("a window shows the same columns as the whole", () => {
  const surfaces = surfacesOf(example.steps),
    now = { step: example.steps.length, fraction: 0 };
  const whole = columnsOf(boundaryIn(cut.final, surfaces, now, -1000, 1000).edges, -41.37, 0.137, 500);
  const part = columnsOf(
    boundaryIn(cut.final, surfaces, now, -41.37 + 60 * 0.137, -41.37 + 97 * 0.137).edges,
    -41.37 + 60 * 0.137,
    0.137,
    37,
  );
  const radii = (gaps: typeof whole.gaps) =>
    gaps.map((each) => each.map(({ low, high }) => [low.toFixed(6), high.toFixed(6)]));
  Array.from(part.top).forEach((r, i) => expect(r).toBeCloseTo(whole.top[60 + i] ?? NaN, 9));
  expect(radii(part.gaps)).toEqual(radii(whole.gaps.slice(60, 97)));
});

const seen = (rings: readonly Ring[], now = done) => {
  const boundary = boundaryIn(rings, surfacesOf(steps), now, -1000, 1000),
    columns = columnsOf(boundary.edges, -70.07, 0.1, 750);
  return { boundary, columns };
};

test("feed lines stand a feed apart from where the cut began, and fade out where they would blur", () => {
  const { boundary, columns } = seen(stockAt(simulation, { step: 2, fraction: 0 }), { step: 2, fraction: 0 });
  const lines = feedLines(boundary, seenOutside(boundary, columns), 40).flatMap((each) => each.lines);
  expect(lines.length).toBeGreaterThan(90);
  lines.slice(1).forEach((l, i) => expect(l.z0 - (lines[i]?.z0 ?? 0)).toBeCloseTo(0.31, 9));
  expect(((lines[0]?.z0 ?? 0) - 2.3) / 0.31).toBeCloseTo(Math.round(((lines[0]?.z0 ?? 0) - 2.3) / 0.31), 6);
  const strength = (pixels: number) =>
    feedLines(boundary, seenOutside(boundary, columns), pixels / 0.31)[0]?.strength ?? 0;
  expect(strength(FEED_LINES.none - 0.1)).toBe(0);
  expect(strength(4)).toBeGreaterThan(0);
  expect(strength(4)).toBeLessThan(strength(7));
  expect(strength(31)).toBe(1);
});

test("lines across stand where the outside turns sharply, and nowhere on a radius", () => {
  const round = Array.from({ length: 19 }, (_, i) => {
    const a = (i * Math.PI) / 36;
    return at(-20.7 - 2.5 * Math.sin(a), 18.3 + 2.5 * Math.cos(a) - 2.5);
  });
  const ring: Ring = [
    at(-40.3, 0),
    at(0, 0),
    at(0, 12.6),
    at(-1.2, 13.8),
    at(-20.7, 18.3),
    ...round.slice(1, 2),
    at(-40.3, 18.2),
  ];
  const { boundary, columns } = seen([ring]);
  expect(turnsOutside(boundary, columns).map((l) => [l.z0, l.r0, l.r1])).toEqual(
    [
      [-40.3, 0, 18.2],
      [0, 0, 12.6],
      [-1.2, 0, 13.8],
      [-20.7, 0, 18.3],
    ].sort((a, b) => boundary.corners.findIndex((c) => c.z === a[0]) - boundary.corners.findIndex((c) => c.z === b[0])),
  );
});

test("a bore shows its walls behind the cut, and the edges of its steps", () => {
  const ring: Ring = [at(-40.3, 5.2), at(-17.6, 5.2), at(-17.6, 9.7), at(0, 9.7), at(0, 20.1), at(-40.3, 20.1)];
  const { boundary, columns } = seen([ring]);
  expect(seenInside(boundary, columns).map((s) => [s.z0, s.z1, s.low, s.r0])).toEqual([
    [-40.3, -17.6, 0, 5.2],
    [-17.6, 0, 0, 9.7],
  ]);
  const lines = turnsInside(boundary, columns).map((l) => [l.z0, l.r0, l.r1]);
  expect(lines).toContainEqual([-17.6, 0, 5.2]);
  expect(lines).toContainEqual([-17.6, 0, 9.7]);
  expect(lines).toContainEqual([0, 0, 9.7]);
});
