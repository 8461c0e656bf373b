import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { playerOf } from "../../sim/stock.ts";
import { surfacesOf } from "../material/surfaces.ts";
import { shownBodies } from "./shown-bodies.ts";

const printed = (cycle: string) => readFileSync(`tests/programs/cycle-${cycle}.h`, "utf8");
/** Cuts into the part after the cycle. */
const gouging = printed("810").replace(
  "12 L Z+52 R0 FMAX",
  "12 L X+30 Z-30 F0.2\n12.1 L X+90 FMAX\n12.2 L Z+52 R0 FMAX",
);

/** The facts announced for a program after a share of its steps. */
function toldOf(text: string, share: number) {
  const made = run(parse(text), { tools: shippedTools, rapid: 8000 }),
    simulation = simulate(made),
    { steps } = made;
  const position = { step: Math.floor(share * steps.length), fraction: 0 };
  return shownBodies(
    playerOf(simulation).at(position),
    { simulation, threads: null, surfaces: surfacesOf(steps) },
    {
      position,
      size: 60,
      turning: { chords: 32, quarterCut: true, hand: 1, within: 0.02, most: 20_000 },
    },
  ).notes;
}

test.each([
  ["residual material", printed("810"), 1, ["residual"]],
  ["residual material, half way", printed("810"), 0.5, []],
  ["contour damage", printed("814"), 1, ["gouge"]],
  ["contour damage, before the cut", printed("814"), 0, []],
  ["both", gouging, 1, ["residual", "gouge"]],
  ["nothing", printed("822"), 1, []],
])("%s is announced once it is visible, and no sooner", (_, text, share, marked) =>
  expect(toldOf(text, share).highlighted).toEqual(marked),
);
