import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import type { Ring } from "../src/kernel/geometry/point.ts";
import { parse } from "../src/nc/parse.ts";
import { exampleJob } from "../src/program/job/job.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { spindleAt } from "../src/sim/load/spindles.ts";
import { simulate } from "../src/sim/simulate.ts";
import type { Chip } from "../src/sim/chip/chip.ts";
import { chipsOf } from "../src/sim/chip/chips.ts";
import { playerOf } from "../src/sim/stock.ts";
import type { PlayPosition, Simulation } from "../src/sim/simulation.ts";
import { fitted, toScreen, type Camera, type Place } from "../src/view/camera.ts";
import { breakData, breakOf } from "../src/view/cutting-tool/break-line.ts";
import { chipMeasure, drawnChip } from "../src/view/cutting-tool/chip-drawing.ts";
import { liesInward, windowsOf } from "../src/view/cutting-tool/covered.ts";
import { toolShapes } from "../src/view/cutting-tool/drawing.ts";
import { liesBehind, silhouetteOf } from "../src/view/cutting-tool/silhouette.ts";
import type { MaterialColours } from "../src/view/material/paint-target.ts";
import { paintMaterial } from "../src/view/material/paint.ts";
import { surfacesOf } from "../src/view/material/surfaces.ts";
import { svgPen } from "../src/view/material/svg-pen.ts";
import { sceneOf, type Scene } from "../src/view/scene.ts";
import { tipAt } from "../src/view/tip.ts";
import type { Run } from "../src/program/state/run-types.ts";

/**
 * Drawings of the lathe view: the painted stock, path and contour, the tool in its holder, and the chip. The printed
 * examples, a bore, a thread, recesses in the face and on the circumference.
 */
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
const SIZE = { width: 420, height: 280 },
  MARGIN = { left: 8, right: 8, top: 8, bottom: 8 };

/** A program of the folder, or the example of a cycle. */
function textOf(name: string): string {
  const cycle = cycleByNumber(Number(name));
  return cycle
    ? printJob(exampleJob(cycle), ncLabels("en"))
    : (programs[`./programs/${name}.h`] ?? expect.fail(`${name} is there`));
}

type Section = "half" | "full" | "outside";

/** Lines and areas in the light colours of the page, as far as their shape distinguishes them. */
const STYLE = [
  ".over path{fill:none;vector-effect:non-scaling-stroke}",
  ".shape-blank{stroke:#52606d;stroke-dasharray:10 3 2 3}",
  ".shape-contour{stroke:#1f2933;stroke-width:2}",
  ".shape-rapid{stroke:#b45309;stroke-dasharray:6 4}",
  ":is(.shape-feed,.shape-smooth,.shape-thread){stroke:#0f766e}",
  ".shape-plunge{stroke:#0f766e;stroke-dasharray:1 4}",
  ".shape-finish{stroke:#0f766e;stroke-width:3}",
  ".over .shape-holder{fill:#c3cad1;stroke:#52606d}",
  ":is(.shape-seam,.shape-centre,.shape-relief,.shape-rest){stroke:#52606d;stroke-width:.75}",
  ".over .shape-pocket{fill:#7b8794}",
  ".over :is(.shape-insert,.shape-guess){fill:#b88a2a;stroke:#1f2933}",
  ".over .shape-screw{fill:#c3cad1;stroke:#1f2933}",
  ".over .shape-drive{fill:#52606d}",
  ".over .chip-area{fill:#a8bcea}",
  ".chip-edge{stroke:#1d4ed8;stroke-width:3}",
  ".chip-measure{stroke:#1f2933}",
  ".over .behind path{fill:none;stroke-dasharray:4 3}",
  ".over .break-ground{fill:#fff}",
  ".break-line{stroke:#52606d}",
].join("");

const paths = (shapes: readonly { readonly role: string; readonly d: string }[]) =>
  shapes.map(({ role, d }) => `<path class="shape-${role}" d="${d}"/>`).join("\n");

/** The tool with its holder at a moment, where the stock does not hide it. */
function toolText(
  steps: Run["steps"],
  stock: readonly Ring[],
  now: PlayPosition,
  camera: Camera,
  section: Section,
): string {
  const tip = tipAt(steps, now),
    step = steps[Math.min(now.step, steps.length - 1)];
  if (!tip || !step) return "";
  const { x, y } = toScreen(camera, tip),
    { scale, xUp } = camera,
    edge = silhouetteOf(stock);
  const covers = section === "outside" || (liesInward(step.tool) && section === "half");
  const isBehind = covers && liesBehind(step.tool, [step.from, step.move.to], edge);
  const broken = breakOf(step.tool, tip, camera, { left: 0, right: SIZE.width, top: 0, bottom: SIZE.height });
  const cut = broken && breakData(broken.width, 9);
  const tool =
    `<g transform="translate(${x.toFixed(2)} ${y.toFixed(2)}) scale(${scale.toFixed(4)} ${(xUp ? -scale : scale).toFixed(4)})">\n` +
    `${paths(toolShapes(step.tool))}\n</g>` +
    (broken && cut
      ? `<g transform="translate(${broken.at.x.toFixed(2)} ${broken.at.y.toFixed(2)}) rotate(${broken.turn})"><path class="break-ground" ` +
        `d="${cut.ground}"/><path class="break-line" d="${cut.line}"/></g>`
      : "");
  const windows = isBehind ? windowsOf(section, camera, SIZE, edge) : null;
  const seenIn = (window: string, more = "") => `<g${more} style="clip-path:${window} view-box">\n${tool}\n</g>`;
  return windows
    ? `${seenIn(windows.seen)}\n${seenIn(windows.other, section === "outside" ? ` class="behind"` : "")}`
    : tool;
}

/** The chip at a moment, the cutting edge and the chip thickness. */
function chipDrawing(chip: Chip | null, at: Place, { scale, xUp }: Camera): string {
  if (!chip) return "";
  const { area, edge } = drawnChip(chip),
    measure = chipMeasure(chip, scale, xUp),
    flip = xUp ? -scale : scale;
  return (
    `<g transform="translate(${at.x.toFixed(2)} ${at.y.toFixed(2)})"><g transform="scale(${scale.toFixed(4)} ${flip.toFixed(4)})">` +
    `<path class="chip-area" d="${area}"/><path class="chip-edge" d="${edge}"/></g>` +
    `${measure ? `<path class="chip-measure" d="${measure.line}"/>` : ""}</g>`
  );
}

/** The layers over the stock. */
function overlay(
  made: Run,
  simulation: Simulation,
  scene: Scene,
  now: PlayPosition,
  look: { readonly camera: Camera; readonly section: Section },
) {
  const { camera, section } = look,
    { zero, scale, xUp } = camera,
    player = playerOf(simulation),
    tip = tipAt(made.steps, now);
  const world = `translate(${zero.x.toFixed(2)} ${zero.y.toFixed(2)}) scale(${scale.toFixed(4)} ${(xUp ? -scale : scale).toFixed(4)})`;
  const chip = now.step < made.steps.length ? chipsOf(made.steps, made.spindles, player)(now) : null;
  return [
    `<style>${STYLE}</style>`,
    `<g class="over">`,
    `<g transform="${world}">`,
    paths(scene.shapes),
    `</g>`,
    toolText(made.steps, player.at(now), now, camera, section),
    tip ? chipDrawing(chip, toScreen(camera, tip), camera) : "",
    `</g>`,
    `</svg>`,
    ``,
  ].join("\n");
}

/** The first cutting moment after a share of the run. */
function cuttingMoment({ steps, spindles }: Run, simulation: Simulation, share: number): PlayPosition {
  const chipOf = chipsOf(steps, spindles, playerOf(simulation)),
    from = Math.floor(share * steps.length);
  const found = steps.findIndex((_, i) => i >= from && chipOf({ step: i, fraction: 0.5 }) !== null);
  return found < 0 ? { step: steps.length, fraction: 0 } : { step: found, fraction: 0.5 };
}

function drawn(program: string, share: number, section: Section, xUp: boolean): string {
  const made = run(parse(textOf(program)), { tools: shippedTools, rapid: 10_000 });
  const simulation = simulate(made),
    surfaces = surfacesOf(made.steps, (step) => spindleAt(made.spindles, step));
  const scene = sceneOf({
    blank: made.blank,
    clamping: made.clamping,
    contours: made.operations.map((o) => o.plan.contour),
    steps: made.steps,
  });
  const now = cuttingMoment(made, simulation, share);
  const { pen, text } = svgPen(SIZE),
    camera = fitted(scene.bounds, SIZE, MARGIN, xUp),
    look = { colours: COLOURS, ratio: 1, origin: { x: 0, y: 0 } };
  paintMaterial(
    pen,
    { rings: playerOf(simulation).at(now), section, now, surfaces, chuck: scene.chuck },
    camera,
    look,
    {
      x: 0,
      y: 0,
      ...SIZE,
    },
  );
  return text().replace(/<\/svg>\s*$/, overlay(made, simulation, scene, now, { camera, section }));
}

describe.each([
  ["812", "half", true],
  ["820", "outside", true],
  ["852", "half", false],
  ["bore-810", "full", true],
  ["831", "half", true],
  ["870", "half", true],
  ["862", "outside", true],
] as const)("%s, %s", (program, section, xUp) => {
  test.each([
    ["middle", 0.537],
    ["end", 1],
  ] as const)("in the %s", async (moment, share) => {
    await expect(drawn(program, share, section, xUp)).toMatchFileSnapshot(`./material/${program}-${moment}.svg`);
  });
});
