import { readFileSync } from "node:fs";
import { join } from "node:path";
import { never } from "../src/kernel/never.ts";
import type { Pt } from "../src/kernel/geometry/point.ts";
import { markedBy, runningPart } from "../src/program/run/path-index.ts";
import type { Run } from "../src/program/state/run-types.ts";
import { playerOf } from "../src/sim/stock.ts";
import type { PlayPosition, Simulation } from "../src/sim/simulation.ts";
import type { Bounds, Camera } from "../src/view/camera.ts";
import { toolShapes } from "../src/view/cutting-tool/drawing.ts";
import { paintMaterial, type Material } from "../src/view/material/paint.ts";
import type { MaterialColours } from "../src/view/material/paint-target.ts";
import { svgPen } from "../src/view/material/svg-pen.ts";
import { pathStretches, wholePath } from "../src/view/passes.ts";
import { sceneOf, type Shape } from "../src/view/scene.ts";
import { transform } from "../src/view/svg.ts";
import { tipAt } from "../src/view/tip.ts";
import { surfacesOfRun } from "../src/app/calculation/moving.ts";
import type { ViewBox } from "../src/view/thumbnail.ts";

/* The lathe view as it is before its program has run: drawn by the painters of the view, in both themes. */

/** Pixels per mm of the drawing: the page scales it to its place. */
const SCALE = 4;
/** What is drawn around the frame, as a share of its size: the place may be wider or taller. */
const AROUND = 0.8;

/** Custom properties of a theme, by name. */
function tokensOf(selector: string): ReadonlyMap<string, string> {
  const css = readFileSync(join("src", "app", "base", "styles", "tokens.css"), "utf8");
  const rules = css.split("}").filter((rule) => rule.includes(`${selector} {`));
  return new Map(
    rules.flatMap((rule) =>
      [...rule.matchAll(/(--[\w-]+):\s*([^;]+);/g)].map(([, name = "", value = ""]) => [name, value] as const),
    ),
  );
}

function coloursOf(selector: string): MaterialColours {
  const tokens = tokensOf(selector);
  const read = (name: string) => tokens.get(name) ?? never(`the style sheets have no ${name}`);
  return {
    ground: read("--material"),
    hatch: read("--material-hatch"),
    edge: read("--steel-edge"),
    steelDark: read("--steel-dark"),
    steel: read("--steel"),
    steelLight: read("--steel-light"),
    chuckDark: read("--chuck-dark"),
    chuck: read("--chuck"),
    chuckLight: read("--chuck-light"),
  };
}

/** Path data with no more digits than show. */
const short = (d: string) => d.replaceAll(/-?\d+\.\d{3,}/g, (v) => String(Math.round(Number(v) * 100) / 100));
const pathsOf = (shapes: readonly Pick<Shape, "d">[]) =>
  (shapes as readonly { readonly role: string; readonly d: string }[])
    .map(({ role, d }) => `<path class="shape-${role}" d="${short(d)}"/>`)
    .join("");

/** A moment of a run within a frame: material and chuck, the path of the running operation, and its tool. */
export function stillPicture(made: Run, simulation: Simulation, at: PlayPosition, frame: Bounds) {
  const [wide, tall] = [frame.right - frame.left, frame.high - frame.low];
  const [beside, over] = [wide * AROUND, tall * AROUND];
  const size = { width: (wide + 2 * beside) * SCALE, height: (tall + 2 * over) * SCALE };
  const camera: Camera = {
    scale: SCALE,
    xUp: true,
    zero: { x: (beside - frame.left) * SCALE, y: (over + frame.high) * SCALE },
  };
  const scene = sceneOf({
    blank: made.blank,
    clamping: made.clamping,
    contours: made.operations.map((o) => o.plan.contour),
    steps: made.steps,
  });
  const material: Material = {
    rings: playerOf(simulation).at(at),
    section: "half",
    now: at,
    surfaces: surfacesOfRun(made),
    chuck: scene.chuck,
  };
  const painted = (colours: MaterialColours) => {
    const { pen, text } = svgPen(size);
    paintMaterial(pen, material, camera, { colours, ratio: 1, origin: { x: 0, y: 0 } }, { x: 0, y: 0, ...size });
    return text()
      .replace(/^<svg[^>]*>/, "")
      .replace(/<\/svg>\s*$/, "")
      .replaceAll("\n", "");
  };
  const choice = runningPart(made, at.step, "operation");
  const path = choice
    ? wholePath(markedBy(made, choice).stretches.flatMap(({ first, last }) => pathStretches(made.steps, first, last)))
    : [];
  const drawn = scene.shapes.filter(({ role }) => role === "blank" || role === "contour");
  const step = made.steps[at.step];
  const tip: Pt | null = tipAt(made.steps, at);
  const tool = step && tip ? `<g transform="translate(${tip.z} ${tip.r})">${pathsOf(toolShapes(step.tool))}</g>` : "";
  const lines = `<g transform="${transform(camera)}" fill="none" stroke-linejoin="round"><path class="lathe-axis" d="M${frame.left - wide} 0H${frame.right + wide}"/><g class="lathe-paths">${pathsOf(path)}</g>${pathsOf(drawn)}${tool}</g>`;
  const box: ViewBox = [beside * SCALE, over * SCALE, wide * SCALE, tall * SCALE];
  return {
    box,
    light: painted(coloursOf(":root")) + lines,
    dark: painted(coloursOf(':root[data-theme="dark"]')) + lines,
  };
}
