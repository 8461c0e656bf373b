import fc from "fast-check";
import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { feed } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { pathInSpace, piecesFrom, segmentsInSpace, thinned } from "./path-lines.ts";

const tool = shippedTools[2] ?? expect.fail("there are tools");
const move = { feed: feed(0.23), feedUnit: "mm/rev", phase: "rough", run: "rough", step: 1 } as const;
const steps: readonly Step[] = (
  [
    { from: at(4.1, 31.7), move: { ...move, kind: "rapid", to: at(1.3, 22.9) } },
    { from: at(1.3, 22.9), move: { ...move, kind: "feed", to: at(-17.7, 22.9) } },
    { from: at(-17.7, 22.9), move: { ...move, kind: "feed", to: at(-17.7, 22.9), dwell: 0.4 } },
    { from: at(-17.7, 22.9), move: { ...move, kind: "arc", to: at(-21, 26.2), centre: at(-17.7, 26.2), turn: "cw" } },
    { from: at(-21, 26.2), move: { ...move, kind: "rapid", to: at(4.1, 31.7) } },
  ] as const
).map((each) => ({ ...each, tool, block: 3, operation: 0, seconds: 1 }) as Step);

test("lines lie in the plane of the tool, by their form, the last first; arcs are chords of the arc", () => {
  const [rapid, cut, ...more] = pathInSpace(steps, () => true);
  expect(more).toEqual([]);
  expect([rapid?.role, cut?.role]).toEqual(["rapid", "feed"]);
  expect([...(rapid?.sources ?? [])]).toEqual([4, 0]);
  const places = [...(cut?.places ?? [])];
  expect(places.filter((_, i) => i % 3 === 1).every((y) => y === 0)).toBe(true);
  // From the end of the arc back to the beginning of the straight cut.
  expect(places.slice(0, 3).map((n) => Number(n.toFixed(4)))).toEqual([26.2, 0, -21]);
  expect(places.slice(-3).map((n) => Number(n.toFixed(4)))).toEqual([22.9, 0, 1.3]);
  const onArc = [...(cut?.sources ?? [])].flatMap((source, i) => (source === 3 ? [6 * i, 6 * i + 3] : []));
  expect(onArc.length).toBeGreaterThan(6);
  for (const i of onArc) expect(Math.hypot((places[i] ?? 0) - 26.2, (places[i + 2] ?? 0) + 17.7)).toBeCloseTo(3.3, 4);
});

test("only shown moves are there, and upcoming pieces can be counted", () => {
  expect(pathInSpace(steps, (step) => step === 1).map(({ role, sources }) => [role, [...sources]])).toEqual([
    ["feed", [1]],
  ]);
  const [rapid, cut] = pathInSpace(steps, () => true);
  if (!rapid || !cut) return expect.fail("there are lines");
  expect([0, 1, 4, 5].map((step) => piecesFrom(rapid, step))).toEqual([2, 1, 1, 0]);
  expect(piecesFrom(cut, 2)).toBe(cut.sources.length - 1);
  expect([piecesFrom(cut, 0), piecesFrom(cut, 4)]).toEqual([cut.sources.length, 0]);
});

test("segments keep their places", () => {
  const { places, sources } = segmentsInSpace([{ kind: "line", from: at(-3.1, 9.7), to: at(-8.4, 11.3) }]);
  expect([...places].map((n) => Number(n.toFixed(3)))).toEqual([11.3, 0, -8.4, 9.7, 0, -3.1]);
  expect([...sources]).toEqual([0]);
});

test("indistinguishable pieces are drawn once, as the last of them; all others stay", () => {
  fc.assert(
    fc.property(
      fc.array(fc.tuple(...[0, 1, 2, 3].map(() => fc.double({ min: -83.7, max: 61.3, noNaN: true }))), {
        minLength: 1,
        maxLength: 60,
      }),
      fc.double({ min: 0.03, max: 40, noNaN: true }),
      (lines, fine) => {
        const all = segmentsInSpace(
          lines.map(([z = 0, r = 0, toZ = 0, toR = 0]) => ({ kind: "line", from: at(z, r), to: at(toZ, toR) })),
        );
        const few = thinned(all, fine),
          ends = ({ places }: typeof all, i: number) => [...places.slice(6 * i, 6 * i + 6)];
        const isNear = (a: number[], b: number[]) => a.every((n, k) => Math.abs(n - (b[k] ?? 0)) < fine);
        const isOne = (a: number[], b: number[]) => isNear(a, b) || isNear(a, [...b.slice(3), ...b.slice(0, 3)]);
        const kept = [...few.sources];
        expect(kept.every((source, i) => source < (kept[i - 1] ?? Infinity))).toBe(true);
        kept.forEach((source, i) => expect(ends(few, i)).toEqual(ends(all, all.sources.indexOf(source))));
        for (const [i, source] of all.sources.entries()) {
          const stand = kept.some((other, k) => other >= source && isOne(ends(few, k), ends(all, i)));
          expect(stand).toBe(true);
        }
      },
    ),
  );
  const twice = segmentsInSpace(
    [0, 0.01, 7.3].map((by) => ({ kind: "line", from: at(-3.11, 9.72 + by), to: at(-8.46, 11.37 + by) })),
  );
  expect([...thinned(twice, 0.25).sources]).toEqual([2, 1]);
  expect([...thinned(twice, 1e-4).sources]).toEqual([2, 1, 0]);
});
