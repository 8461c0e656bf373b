import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { playerOf } from "../../sim/stock.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { colouredBodies, statedSteps } from "./bodies.ts";
import { bodiesAt } from "./moment.ts";
import { runThreads } from "./thread-cuts.ts";
import type { ThreadTurning } from "./threaded.ts";

const fine: ThreadTurning = { chords: 32, quarterCut: true, hand: 1, within: 0.02, most: 100_000 };

function moments(text: string) {
  const { blank, stated, steps, operations, unproved } = run(parse(text), { tools: shippedTools, rapid: 8000 });
  const simulation = simulate({ blank, stated, steps, operations, unproved }),
    player = playerOf(simulation);
  const threads = runThreads(steps, player.at, { stated: statedSteps(simulation) });
  const at = (position: PlayPosition) =>
    bodiesAt({ stock: player.at(position), simulation, threads, position, size: 60 }, fine);
  const leftAt = (position: PlayPosition) => colouredBodies(player.at(position), simulation, position, 60).residual;
  return { steps, at, threads, leftAt, residual: simulation.proof.residual };
}
const printed = readFileSync("tests/programs/cycle-831.h", "utf8");

test("a moment has the same body however it is reached, and a thread is a helix from its first cut on", () => {
  const { steps, at } = moments(printed),
    first = steps.findIndex(({ move }) => move.kind === "thread");
  const places = [first + 0.6, first + 8.31, steps.length, first + 3, first + 0.6].map((n) => ({
    step: Math.floor(n),
    fraction: n % 1,
  }));
  const sizes = places
    .map((place) => at(place))
    .map(({ bodies, hasRings }) => [hasRings, bodies[0]?.solid.surface.index.length]);
  expect(sizes.every(([rings]) => rings === false)).toBe(true);
  expect(sizes[0]).toEqual(sizes.at(-1));
  expect(at({ step: first, fraction: 0 }).hasRings).toBe(false);
  expect(at({ step: first, fraction: 0 }).bodies[0]?.solid.surface.index.length).toBeLessThan(1000);
});

test("a thread in a cone is a helix while its first turns are cut", () => {
  const { at } = moments(readFileSync("tests/programs/cycle-832.h", "utf8"));
  const moment = [0.38, 0.42, 0.46].map((fraction) => at({ step: 4, fraction }));
  expect(moment.map(({ hasRings }) => hasRings)).toEqual([false, false, false]);
});

test("material turned off after the thread is missing from it", () => {
  const cut = "9.1 L X+40 Z+3 FMAX\n9.2 L X+28.6 F0.2\n9.3 L Z-9.3\n9.4 L X+50\n9.5 L Z+30 FMAX\n";
  const { steps, at } = moments(printed.replace("10 L X+60", `${cut}10 L X+60`));
  expect(at({ step: steps.length, fraction: 0 }).hasRings).toBe(false);
});

test("a program without threads has none", () => {
  expect(moments(readFileSync("src/examples/flange.h", "utf8")).threads).toBeNull();
});

test.each([
  ["830", 11, 1000],
  ["832", 1, 0],
])("residual material between the grooves of cycle %s is coloured where it remains", (cycle, least, corners) => {
  const { steps, at, residual, leftAt } = moments(readFileSync(`tests/programs/cycle-${cycle}.h`, "utf8"));
  const { bodies, hasRings } = at({ step: steps.length, fraction: 0 });
  expect(hasRings).toBe(false);
  const left = leftAt({ step: steps.length, fraction: 0 });
  expect(residual.length).toBeGreaterThanOrEqual(least);
  const told = bodies.filter(({ role }) => role === "residual").map(({ solid }) => solid);
  // In the half plane of the stock, with x upwards and y = 0, the coloured area equals the residual area.
  const area = told.reduce((sum, { section: { positions: p, index, normals } }) => {
    let all = sum;
    for (let t = 0; t < index.length; t += 3) {
      const [a = 0, b = 0, c = 0] = [0, 1, 2].map((k) => 3 * (index[t + k] ?? 0));
      if (normals[a + 1] !== 1) continue;
      const [x, z] = [(i: number) => p[i] ?? 0, (i: number) => p[i + 2] ?? 0];
      all += Math.abs((x(b) - x(a)) * (z(c) - z(a)) - (z(b) - z(a)) * (x(c) - x(a))) / 2;
    }
    return all;
  }, 0);
  // The fine lines of the helix may differ from the corners of the stock by the requested tolerance.
  expect(Math.abs(area / areaOf(left) - 1)).toBeLessThan(0.08);
  const cut = Math.max(...told.map(({ surface }) => surface.index.length));
  expect(cut).toBeGreaterThanOrEqual(corners);
});
