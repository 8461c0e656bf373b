import { expect, test } from "vitest";
import type { PlayPosition } from "../../sim/simulation.ts";
import { chipsOf } from "../../sim/chip/chips.ts";
import { simulate } from "../../sim/simulate.ts";
import { playerOf } from "../../sim/stock.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import shoulder from "../../examples/shoulder.h?raw";
import { fitted } from "../camera.ts";
import { ringData } from "../path.ts";
import { svgText } from "../svg.ts";
import { tipAt } from "../tip.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { chipMeasure, drawnChip } from "./chip-drawing.ts";
import { toolShapes } from "./drawing.ts";

const work = run(parse(shoulder), { tools: shippedTools, rapid: 10_000 });
const player = playerOf(simulate(work));
const chips = chipsOf(work.steps, work.spindles, player);
/** The longest roughing cut, a good way along it. */
const longest = work.steps.reduce(
  (best, step, i) =>
    step.move.phase === "rough" && step.move.kind === "feed" && step.seconds > (work.steps[best]?.seconds ?? 0)
      ? i
      : best,
  0,
);
const moment: PlayPosition = { step: longest, fraction: 0.437 };

test("a moment of contact matches its golden drawing", async () => {
  const chip = chips(moment),
    tip = tipAt(work.steps, moment),
    tool = work.steps[longest]?.tool;
  if (!chip || !tip || !tool) throw new Error("nothing is cut");
  const beside = (ring: Ring): Ring => ring.map((p) => at(p.z - tip.z, p.r - tip.r));
  const { area, edge } = drawnChip(chip),
    size = { width: 480, height: 360 };
  const shapes = [
    { role: "stock", d: ringData(player.at(moment).map(beside)) },
    ...toolShapes(tool),
    { role: "chip-area", d: area },
    {
      role: "chip-edge",
      d: edge,
    },
  ];
  const camera = fitted({ left: -4, right: 4, low: -2, high: 4 }, size, { left: 0, right: 0, top: 0, bottom: 0 }, true);
  await expect(svgText(shapes, camera, size)).toMatchFileSnapshot("../goldens/contact.svg");
});

test("without a chip nothing is drawn", () => {
  const rapid = work.steps.findIndex(({ move }) => move.kind === "rapid");
  expect(chips({ step: rapid, fraction: 0.5 })).toBeNull();
  expect(drawnChip(null)).toEqual({ area: "", edge: "" });
});

test("the thickness is written beside the edge where the zoom has room for it, on the side of the steel", () => {
  const chip = chips(moment);
  if (!chip) throw new Error("nothing is cut");
  const enough = 7.3 / chip.thickest.size;
  expect(chipMeasure(chip, enough * 0.9, true)).toBeNull();
  const measure = chipMeasure(chip, enough, true);
  // The edge of a right-hand tool cuts towards the chuck.
  expect(measure?.anchor).toBe("end");
  expect(measure?.text.x).toBeLessThan(chip.thickest.from.z * enough - 16);
  const [up, down] = [measure, chipMeasure(chip, enough, false)];
  expect(up?.line.split("M")).toHaveLength(4);
  expect(down?.text.x).toBe(up?.text.x);
});
