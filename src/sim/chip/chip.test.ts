import { expect, test } from "vitest";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { degrees, feed, length } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../simulate.ts";
import { playerOf } from "../stock.ts";
import { chipAt, sameChip, type ChipWork } from "./chip.ts";

const tools = Object.fromEntries(shippedTools.map((tool) => [tool.T, tool]));
const blank: Ring[] = [[at(-61, 0), at(0, 0), at(0, 24.37), at(-61, 24.37)]];
const rough = { phase: "rough", run: "rough", pass: 1, step: 2 } as const;
const cut = (to: Pt, f: number, feedUnit: "mm/rev" | "mm/min" = "mm/rev") =>
  ({ kind: "feed", to, feed: feed(f), feedUnit, ...rough }) as const;
const rapid = (to: Pt) => ({ kind: "rapid", to, ...rough }) as const;

/** A run of moves with one tool, and its chip at any moment. */
function work(
  tool: Tool,
  start: Pt,
  moves: readonly Step["move"][],
  speed = 1000,
  stock = blank,
): (step: number, fraction: number) => ReturnType<typeof chipAt> {
  let from = start;
  const steps = moves.map((move): Step => {
    const step = { from, move, tool, block: 1, operation: null, seconds: 1 };
    from = move.to;
    return step;
  });
  const simulation = simulate({ blank: stock, steps, operations: [], unproved: [] });
  const asked: ChipWork = {
    steps,
    outlineOf: (each) => insertOutline(each, CHORD),
    spindles: [{ step: 0, spindle: { kind: "constant", speed } }],
    before: playerOf(simulation).before,
  };
  return (step, fraction) => chipAt(asked, { step, fraction });
}

const CNMG = tools[1] as Tool;
const sharp = { ...CNMG, RS: length(0) };
/** Area of the feed mark left by a sharp 80° insert at 95°, divided by the feed squared. */
const MARK = 1 / (2 / Math.tan(Math.PI / 36) - 2 * Math.tan(Math.PI / 36));
const areaAt = (depth: number, f: number) => depth * f - MARK * f ** 2;
const pass = work(CNMG, at(3, 22.24), [cut(at(-41.7, 22.24), 0.317), rapid(at(3, 25))]);

test("an outside pass cuts depth times feed; the entering angle gives the chip thickness", () => {
  const chip = work(sharp, at(3, 22.24), [cut(at(-41.7, 22.24), 0.317)])(0, 0.6);
  expect(chip?.feed).toBe(0.317);
  expect(chip?.depth).toBeCloseTo(2.13, 3);
  expect(chip?.area).toBeCloseTo(areaAt(2.13, 0.317), 4);
  // 95° between edge and feed: f · sin κ, and ap / sin κ along the main edge. The secondary edge cuts along the
  // previous feed mark.
  expect(chip?.thickest.size).toBeCloseTo(0.317 * Math.sin((95 * Math.PI) / 180), 3);
  const [sin95, sin80] = [95, 80].map((angle) => Math.sin((angle * Math.PI) / 180)) as [number, number];
  expect(chip?.width).toBeCloseTo(2.13 / sin95 + (0.317 * sin95) / sin80, 3);
});

test("a nose radius keeps depth and thickness, and lengthens the engaged edge", () => {
  const chip = pass(0, 0.6);
  expect(chip?.depth).toBeCloseTo(2.13, 3);
  expect(chip?.area).toBeCloseTo(2.13 * 0.317, 1);
  // At some point of the nose the edge is square to the feed.
  expect(chip?.thickest.size).toBeGreaterThan(0.3158);
  expect(chip?.thickest.size).toBeLessThan(0.31701);
  expect(chip?.width).toBeGreaterThan(2.3);
  expect(chip?.contact).toHaveLength(1);
  for (const p of chip?.contact[0] ?? []) expect(Math.abs(p.z)).toBeLessThan(1.01);
});

test("rapids, air cuts and the return over a finished surface have no chip", () => {
  expect(pass(0, 0.01)).toBeNull();
  expect(pass(1, 0.5)).toBeNull();
  const twice = work(CNMG, at(3, 22.24), [
    cut(at(-41.7, 22.24), 0.317),
    rapid(at(-41.7, 25)),
    rapid(at(3, 25)),
    rapid(at(3, 22.24)),
    cut(at(-30.1, 22.24), 0.317),
  ]);
  expect(twice(0, 0.5)).not.toBeNull();
  expect(twice(4, 0.5)).toBeNull();
});

test("the first revolution cuts only what has entered, and a revolution spans joined moves", () => {
  const whole = work(sharp, at(3, 22.24), [cut(at(-20, 22.24), 0.317)]);
  const inside = (way: number) => (3 + way) / 23;
  const begun = whole(0, inside(0.1));
  // The edge leans back by 5°, so only its lower end has entered the stock.
  expect(begun?.area).toBeCloseTo(0.1 ** 2 / (2 * Math.tan(Math.PI / 36)) - MARK * 0.1 ** 2, 4);
  const parted = work(sharp, at(3, 22.24), [
    cut(at(-9.9, 22.24), 0.317),
    cut(at(-10, 22.24), 0.317),
    cut(at(-20, 22.24), 0.317),
  ]);
  const [one, three] = [whole(0, 13.11 / 23), parted(2, 0.011)];
  expect(three?.area).toBeCloseTo(one?.area ?? NaN, 4);
  expect(sameChip(one, three)).toBe(true);
});

test("a feed in mm/min counts with the speed of the spindle", () => {
  const chip = work(sharp, at(3, 22.24), [cut(at(-41.7, 22.24), 190.2, "mm/min")], 600)(0, 0.6);
  expect(chip?.feed).toBeCloseTo(0.317, 9);
  expect(chip?.area).toBeCloseTo(areaAt(2.13, 0.317), 4);
});

test("a plunging blade cuts its width times its feed with its whole edge", () => {
  const blade = tools[9] as Tool;
  const chip = work(blade, at(-20.3, 27), [cut(at(-20.3, 19.1), 0.083)])(0, 0.7);
  expect(chip?.depth).toBeCloseTo(3, 3);
  expect(chip?.area).toBeCloseTo(3 * 0.083, 2);
  expect(chip?.thickest.size).toBeCloseTo(0.083, 3);
  expect(chip?.width).toBeCloseTo(3, 0);
});

test("a boring bar cuts on the side of the wall", () => {
  const tube: Ring[] = [[at(-61, 11.5), at(0, 11.5), at(0, 24.37), at(-61, 24.37)]];
  const chip = work(
    { ...(tools[5] as Tool), RS: length(0) },
    at(2, 12.63),
    [cut(at(-30, 12.63), 0.21)],
    900,
    tube,
  )(0, 0.5);
  expect(chip?.depth).toBeCloseTo(1.13, 3);
  expect(chip?.area).toBeCloseTo(areaAt(1.13, 0.21), 4);
});

test("a thread takes its infeed on both flanks, once a turn", () => {
  const sharp60 = { ...(tools[12] as Tool), RS: length(0) };
  const turn = (r: number): Step["move"] => ({
    kind: "thread",
    to: at(-29.3, r),
    pitch: length(2.7),
    axis: "z",
    angle: degrees(40),
    stops: true,
    phase: "thread",
    pass: 1,
    run: "rough",
    step: 2,
  });
  const moves = [turn(24.17), rapid(at(-29.3, 26)), rapid(at(4.1, 26)), rapid(at(4.1, 24.04)), turn(24.04)];
  const chip = work(sharp60, at(4.1, 24.17), moves);
  expect(chip(0, 0.02)).toBeNull();
  const [first, second] = [chip(0, 0.5), chip(4, 0.5)];
  const flank = Math.tan(Math.PI / 6);
  expect(first?.area).toBeCloseTo(0.2 ** 2 * flank, 4);
  expect(first?.feed).toBe(2.7);
  expect(second?.area).toBeCloseTo((0.33 ** 2 - 0.2 ** 2) * flank, 4);
  expect(second?.depth).toBeCloseTo(0.13, 3);
  expect(second?.thickest.size).toBeCloseTo(0.13 / 2, 3);
  expect(second?.width).toBeCloseTo((2 * 0.33) / Math.cos(Math.PI / 6), 2);
  expect(sameChip(second, chip(4, 0.53))).toBe(true);
});

test("seeking back and forth gives the same chip as playing on", () => {
  const moves = [
    cut(at(-41.7, 23.1), 0.3),
    rapid(at(3, 25)),
    rapid(at(3, 22.24)),
    cut(at(-20, 22.24), 0.317),
    cut(at(-20.2, 22.24), 0.317),
    cut(at(-33, 22.24), 0.317),
  ];
  const [forward, seeking] = [work(CNMG, at(3, 23.1), moves), work(CNMG, at(3, 23.1), moves)];
  const seek = seeking(5, 0.005);
  seeking(0, 0.4);
  const again = seeking(5, 0.005);
  const gone = [0.1, 0.5, 0.9]
    .map((fraction) => forward(3, fraction))
    .concat(forward(5, 0.005))
    .at(-1);
  expect(seek?.area).toBeCloseTo(0.317 * 0.86, 1);
  expect(again).toEqual(seek);
  expect(gone).toEqual(seek);
});
