import { expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import { stampsOf, turnsIn, type ThreadMove } from "../kernel/time/thread-turns.ts";
import { axial, degrees, length, radius } from "../kernel/units.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { simulate } from "./simulate.ts";
import { playerOf } from "./stock.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const blank: Ring[] = [[at(-37, 0), at(0, 0), at(0, 14.3), at(-37, 14.3)]];
const tool = { ...(shippedTools.find((t) => t.TYPE === "THREAD") as Tool), RS: length(0) };
const thread = (to: Pt, angle: number, stops = false): ThreadMove => ({
  kind: "thread",
  to,
  pitch: length(2.7),
  axis: "z",
  angle: degrees(angle),
  stops,
  phase: "thread",
  pass: 1,
  run: "rough",
  step: 2,
});
const step = (from: Pt, move: Step["move"]): Step => ({ from, move, tool, block: 1, operation: null, seconds: 1 });

test("a thread crosses the half plane once per revolution, from its angle on, and where the tool stops", () => {
  const from = at(4.1, 12.9);
  const places = (angle: number, stops = false) =>
    stampsOf(from, thread(at(-4, 12.9), angle, stops)).map((s) => Number(s.at.z.toFixed(6)));
  expect(turnsIn(from, thread(at(-4, 12.9), 0))).toBeCloseTo(3, 9);
  expect(places(0)).toEqual([4.1, 1.4, -1.3]);
  expect(places(90)).toEqual([2.075, -0.625, -3.325]);
  expect(places(90, true)).toEqual([2.075, -0.625, -3.325, -4]);
});

test("a thread continued at its reached angle equals the thread in one move", () => {
  const [from, middle, to] = [at(4.1, 12.9), at(-9.37, 12.9), at(-31, 12.9)];
  const reached = (250 + 360 * turnsIn(from, thread(middle, 0))) % 360;
  const whole = stampsOf(from, thread(to, 250)).map((s) => s.at.z);
  const parts = [...stampsOf(from, thread(middle, 250)), ...stampsOf(middle, thread(to, reached))].map((s) => s.at.z);
  expect(parts.length).toBe(whole.length);
  parts.forEach((z, i) => expect(z).toBeCloseTo(whole[i] ?? NaN, 9));
});

test("it leaves teeth a lead apart, and does not remove the band between crest and root", () => {
  const steps = [step(at(4.1, 12.9), thread(at(-29.3, 12.9), 40, true))];
  const simulation = simulate({ blank, steps, operations: [], unproved: [] });
  const groove = 1.4 ** 2 * Math.tan(Math.PI / 6);
  // Eleven revolutions in the part, and the groove where the tool stops.
  const stamps = stampsOf(at(4.1, 12.9), steps[0]?.move as ThreadMove).filter((s) => s.at.z < -0.9);
  expect(areaOf(blank) - areaOf(simulation.final)).toBeCloseTo(stamps.length * groove, 1);
  const player = playerOf(simulation);
  expect(player.at({ step: 1, fraction: 0 })).toEqual(simulation.final);
  const half = areaOf(blank) - areaOf(player.at({ step: 0, fraction: 0.5 }));
  expect(half / groove).toBeGreaterThan(4);
  expect(half / groove).toBeLessThan(7);
});
