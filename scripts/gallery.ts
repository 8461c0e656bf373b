import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Cycle, Group } from "../src/cycles/define.ts";
import { cuttingCycles, cycleByNumber, type CycleNumber } from "../src/cycles/index.ts";
import { texts } from "../src/i18n/index.ts";
import { parse } from "../src/nc/parse.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import type { Run } from "../src/program/state/run-types.ts";
import { run } from "../src/program/run/run.ts";
import { verdictOf, type Judged } from "../src/report/verdict.ts";
import { simulate } from "../src/sim/simulate.ts";
import type { Simulation } from "../src/sim/simulation.ts";
import { fitted } from "../src/view/camera.ts";
import { ringData } from "../src/view/path.ts";
import { escapedText } from "../src/view/markup.ts";
import { PATH_ROLES, sceneOf, type Shape } from "../src/view/scene.ts";
import { svgText } from "../src/view/svg.ts";
import { cyclePicture, pictureHatches, pictureRules } from "./cycle-picture.ts";
import { styled } from "./page-colours.ts";

const { cycles, findings } = texts("en");
const RAPID = 10_000;
const SIZE = { width: 520, height: 300 };
const MARGIN = { left: 8, right: 8, top: 8, bottom: 8 };

function clock(seconds: number): string {
  const whole = Math.round(seconds);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours} h ${minutes} min` : `${minutes} min ${String(whole % 60).padStart(2, "0")} s`;
}
const many = (n: number, one: string) => `${n} ${one}${n === 1 ? "" : "es"}`;

/** The part, the remaining stock, and the path, from back to front. */
function picture(made: Run, simulation: Simulation): string {
  const scene = sceneOf({
    blank: made.blank,
    clamping: made.clamping,
    contours: made.operations.map((o) => o.plan.contour),
    steps: made.steps,
  });
  const isPath = (s: Shape) => (PATH_ROLES as readonly string[]).includes(s.role);
  const over = (s: Shape) => isPath(s) || s.role === "blank" || s.role === "contour";
  const left = simulation.proof.residual.map((piece) => piece.ring);
  const shapes: Shape[] = [
    ...scene.shapes.filter((s) => !over(s)),
    { role: "stock", d: ringData(simulation.final) },
    ...(left.length > 0 ? [{ role: "residual" as const, d: ringData(left) }] : []),
    ...scene.shapes.filter(over),
  ];
  return svgText(shapes, fitted(scene.bounds, SIZE, MARGIN, true), SIZE).replace("<svg ", '<svg class="work" ');
}

/** The verdict in short. */
function verdictText({ verdict }: Judged, left: number): string {
  if (verdict === "incomplete") return findings.verdict.unproved;
  return left > 0.01 ? findings.verdict.stays(`${left.toFixed(2)} mm²`) : findings.verdict.proved;
}

interface Work {
  readonly name: string;
  readonly cycle: Cycle;
  readonly figure: string;
}

/** One golden program with a turning operation; null for one without, or with faults. */
function work(name: string, text: string): Work | null {
  const made = run(parse(text), { tools: shippedTools, rapid: RAPID });
  const [first] = made.operations;
  const cycle = first && cycleByNumber(first.cycle);
  if (!cycle) return null;
  const simulation = simulate(made);
  const judged = verdictOf(made, simulation);
  // Programs with planted faults are for the tests.
  if (judged.verdict === "faults") return null;
  const left = simulation.proof.residual.reduce((sum, piece) => sum + piece.area, 0);
  const passes = made.operations.reduce((sum, o) => sum + o.plan.passes, 0);
  const numbers = [...new Set(made.operations.map((o) => `${o.cycle} with tool ${o.tool.T}`))].join(", ");
  const said = [numbers, many(passes, "pass"), clock(made.seconds)].join(" · ");
  return {
    name,
    cycle,
    figure:
      `<figure>${picture(made, simulation)}<figcaption><code>${escapedText(name)}</code>` +
      `<span class="${judged.verdict}">${escapedText(verdictText(judged, left))}</span><span>${escapedText(said)}</span></figcaption></figure>`,
  };
}

/** The help picture of a cycle under its number and name. */
function cycleFigure(cycle: Cycle): string {
  const drawn = cyclePicture(cycle);
  const name = `${cycle.number} ${cycles.of[cycle.number as CycleNumber].name}`;
  return drawn === null ? "" : `<figure>${drawn}<figcaption><b>${escapedText(name)}</b></figcaption></figure>`;
}

const RULES = `
body {
  margin: 0 auto; max-width: 1640px; padding: 16px 20px 40px;
  background: var(--page); color: var(--text); font: 14px/1.5 var(--text-font);
}
h1 { font-size: 24px; margin: 8px 0 0; }
h2 { font-size: 18px; margin: 32px 0 8px; }
h3 { font-size: 14px; margin: 16px 0 6px; color: var(--text-soft); }
a { color: var(--accent); } nav { display: flex; flex-wrap: wrap; gap: 4px 16px; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(380px, 100%), 1fr)); gap: 12px; }
figure { margin: 0; background: var(--surface); border: 1px solid var(--line); border-radius: 6px; overflow: hidden; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { display: flex; flex-wrap: wrap; gap: 2px 12px; padding: 6px 10px; border-top: 1px solid var(--line); font-size: 13px; }
code { font-family: var(--number-font); font-weight: 600; }
.proved { color: var(--good); } .incomplete { color: var(--warning); }
.work path { fill: none; vector-effect: non-scaling-stroke; stroke-linejoin: round; fill-rule: evenodd; }
.work .stock { fill: var(--material); stroke: var(--line-strong); } .work .blank { stroke: var(--line-strong); stroke-dasharray: 10 3 2 3; }
.work .residual { fill: var(--surface); stroke: var(--residual); stroke-width: 2.5; }
.work .contour { stroke: var(--contour); stroke-width: 1.75; }
.work .rapid { stroke: var(--rapid); stroke-dasharray: 6 4; } .work .feed, .work .smooth { stroke: var(--feed); }
.work .plunge { stroke: var(--feed); stroke-width: 2; stroke-dasharray: 0.1 4; stroke-linecap: round; }
.work .finish { stroke: var(--feed); stroke-width: 2.5; } .work .thread { stroke: var(--feed); stroke-dasharray: 8 3 2 3; }
.patterns { position: absolute; }
@media print { figure { break-inside: avoid; } }
`;

/** Families in the order of the chooser. */
const ORDER: readonly Group[] = ["longitudinal", "transverse", "recessTurning", "recessing", "thread"];

/**
 * The page: for each family its cycles with their help pictures, and the golden programs that start with one of them.
 * Runs in the project folder.
 */
function page(): string {
  const folder = join("tests", "programs");
  const works = readdirSync(folder)
    .filter((name) => name.endsWith(".h"))
    .sort()
    .flatMap((name) => work(name, readFileSync(join(folder, name), "utf8")) ?? []);
  const groups = ORDER.filter((group) => cuttingCycles.some((c) => c.group === group));
  const sections = groups.map((group) => {
    const own = cuttingCycles.filter((c) => c.group === group);
    const programs = works.filter((w) => w.cycle.group === group);
    const goldens = `<h3>Programs</h3><div class="figures">${programs.map((w) => w.figure).join("\n")}</div>`;
    return `<section id="${group}"><h2>${escapedText(cycles.groups[group])}</h2><h3>Cycles</h3><div class="figures">${own
      .map(cycleFigure)
      .join("\n")}</div>${programs.length > 0 ? goldens : ""}</section>`;
  });
  const links = groups.map((group) => `<a href="#${group}">${escapedText(cycles.groups[group])}</a>`).join("");
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self'">
<title>Turnwise: cycle gallery</title><link rel="stylesheet" href="./gallery.css"></head>
<body>
<svg class="help-picture patterns" width="0" height="0" aria-hidden="true">${pictureHatches()}</svg>
<header><h1>Cycle gallery</h1>
<p>Every cycle with its help picture, and ${works.length} test programs as simulated: part, residual material, path, result of the check,
passes and time. Our reading of the manuals; verify on your control. <a href="./">Turnwise</a></p>
<nav>${links}</nav></header>
<main>${sections.join("\n")}</main></body></html>
`;
}

/** The files of the gallery by name: the content policy allows no styles within a page. */
export const galleryFiles = (): Readonly<Record<string, string>> => ({
  "gallery.html": page(),
  "gallery.css": styled(RULES + pictureRules()),
});

/** `npm run gallery`: writes the gallery into dist/, as the build does. */
export function main(): number {
  mkdirSync("dist", { recursive: true });
  for (const [name, text] of Object.entries(galleryFiles())) writeFileSync(join("dist", name), text);
  console.log(join("dist", "gallery.html"));
  return 0;
}
