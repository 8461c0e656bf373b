import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import { exampleJob } from "../src/program/job.ts";
import { printJob } from "../src/program/print-job.ts";
import { run } from "../src/program/run.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";
import { spindleAt } from "../src/sim/load/spindles.ts";
import { simulate } from "../src/sim/simulate.ts";
import { stockAt } from "../src/sim/stock.ts";
import { fitted } from "../src/view/camera.ts";
import type { MaterialColours } from "../src/view/material/easel.ts";
import { paintMaterial } from "../src/view/material/paint.ts";
import { surfacesOf } from "../src/view/material/surfaces.ts";
import { svgPen } from "../src/view/material/svg-pen.ts";
import { sceneOf } from "../src/view/scene.ts";

/** The work as the lathe view paints it, kept as drawings: the printed examples, a bore, a thread, recesses in the face and around. */
const programs = import.meta.glob<string>("./programs/*.h", { query: "?raw", import: "default", eager: true });

const COLOURS: MaterialColours = {
  ground: "#c9d1d9",
  hatch: "#8a96a3",
  edge: "#52606d",
  steelDark: "#5b6772",
  steel: "#aeb9c4",
  steelLight: "#f6f8fa",
  chuckDark: "#78848f",
  chuck: "#a9b4be",
  chuckLight: "#cfd7de",
};
const SIZE = { width: 420, height: 280 }, MARGIN = { left: 8, right: 8, top: 8, bottom: 8 };

/** A program of the folder, or the example of a cycle. */
function textOf(name: string): string {
  const cycle = cycleByNumber(Number(name));
  return cycle ? printJob(exampleJob(cycle), ncLabels("en")) : programs[`./programs/${name}.h`] ?? expect.fail(`${name} is there`);
}

function drawn(program: string, share: number, section: "half" | "full" | "outside", xUp: boolean): string {
  const made = run(parse(textOf(program)), { tools: shippedTools, rapid: 10_000 });
  const simulation = simulate(made), surfaces = surfacesOf(made.steps, (step) => spindleAt(made.spindles, step));
  const scene = sceneOf({ blank: made.blank, contours: made.operations.map((o) => o.plan.contour), steps: made.steps });
  const at = share * made.steps.length, now = { step: Math.floor(at), fraction: at % 1 };
  const { pen, text } = svgPen(SIZE), camera = fitted(scene.bounds, SIZE, MARGIN, xUp),
    look = { colours: COLOURS, ratio: 1, origin: { x: 0, y: 0 } };
  paintMaterial(pen, { rings: stockAt(simulation, now), section, now, surfaces, chuck: scene.chuck }, camera, look, {
    x: 0,
    y: 0,
    ...SIZE,
  });
  return text();
}

describe.each(
  [["812", "half", true], ["820", "outside", true], ["852", "half", false], ["bore-810", "full", true], ["831", "half", true], [
    "870",
    "half",
    true,
  ], ["862", "outside", true]] as const,
)("%s, %s", (program, section, xUp) => {
  test.each([["middle", 0.537], ["end", 1]] as const)("in the %s", async (moment, share) => {
    await expect(drawn(program, share, section, xUp)).toMatchFileSnapshot(`./material/${program}-${moment}.svg`);
  });
});
