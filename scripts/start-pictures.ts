import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { LiveRun, StartPictures, Waypoint } from "../src/features/start/pictures.ts";
import type { ExampleId } from "../src/examples/index.ts";
import { insertOutline } from "../src/kernel/cutter/insert.ts";
import { part, type Pt, type Ring } from "../src/kernel/geometry/point.ts";
import type { Step } from "../src/kernel/time/step.ts";
import { parse } from "../src/nc/parse.ts";
import type { Run } from "../src/program/state/run-types.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { verdictOf } from "../src/report/verdict.ts";
import { simulate } from "../src/sim/simulate.ts";
import { boundsOf } from "../src/view/bounds.ts";
import { unstatedClamping } from "../src/view/unstated-clamping.ts";
import { thumbBox, thumbnailOf, thumbPlace, thumbRings, type Thumbnail, type ViewBox } from "../src/view/thumbnail.ts";

const RAPID = 10_000;
/** The program of the live picture, and the files of the examples. Runs in the project folder. */
const LIVE = "shoulder";
const FILES: Readonly<Record<ExampleId, string>> = {
  shaft: "shaft",
  flange: "flange",
  shoulder: "shoulder",
  contour: "contour",
  contourEnglish: "contour-en",
  groove: "groove",
  plate: "plate",
};

const ran = (file: string): Run =>
  run(parse(readFileSync(join("src", "examples", `${file}.h`), "utf8")), { tools: shippedTools, rapid: RAPID });

/** Finer than any screen shows, mm. */
const FINE = 0.05;
const drawn = (rings: readonly Ring[]) => thumbRings(rings, FINE);

const rounded = (v: number) => Math.round(v * 100) / 100;

/** The path of a mill, seen from above; Y points up. */
function planeThumbnail({ plane }: Run): Thumbnail | null {
  const cut = plane.filter(({ kind }) => kind !== "rapid");
  const all = cut.flatMap(({ from, to }) => [from, to]);
  if (all.length === 0) return null;
  const [xs, ys] = [all.map(({ x }) => x), all.map(({ y }) => -y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const air = Math.max(width, height) / 16;
  const box = [left - air, top - air, width + 2 * air, height + 2 * air].map(rounded) as unknown as ViewBox;
  const way = cut
    .map(({ from, to }) => `M${rounded(from.x)} ${rounded(-from.y)}L${rounded(to.x)} ${rounded(-to.y)}`)
    .join("");
  return { box, part: "", blank: "", plane: way };
}

/** The finished part of a program; null where nothing is turned. */
function thumbnail(file: string): Thumbnail | null {
  const made = ran(file);
  return made.operations.length === 0 ? planeThumbnail(made) : thumbnailOf(made.blank, simulate(made).final);
}

/** Speeds of the picture, mm/s: it shows the order of moves, not their time. */
const SHOWN = { rapid: 150, feed: 34 };
/** Segments of an arc. */
const PIECES = 8;

const pointsTo = ({ from, move }: Step): readonly Pt[] =>
  move.kind === "arc"
    ? Array.from({ length: PIECES }, (_, i) =>
        part.pointOn({ kind: "arc", from, to: move.to, centre: move.centre, turn: move.turn }, (i + 1) / PIECES),
      )
    : [move.to];

/** The pass of a step: 0 for a rapid, -1 for a finishing cut. */
const passOf = ({ move }: Step): number => {
  if (move.kind === "rapid") return 0;
  return move.run === "finish" ? -1 : (move.pass ?? 0);
};

function live(file: string): LiveRun {
  const made = ran(file);
  const [operation] = made.operations;
  if (!operation) throw new Error(`${file}.h turns nothing`);
  const steps = made.steps.filter((step) => step.operation !== null);
  const simulation = simulate(made);
  const stockAfter = (count: number) =>
    drawn(simulate({ blank: made.blank, steps: steps.slice(0, count), operations: [], unproved: [] }).final);
  const stocks = [drawn(made.blank)];
  const first = steps[0]?.from ?? made.blank[0]?.[0];
  if (!first) throw new Error(`${file}.h goes nowhere`);
  const way: Waypoint[] = [[0, first.z, first.r, 0, 0]];
  let time = 0;
  let [rapids, feeds] = ["", ""];
  let here = first;
  steps.forEach((step, i) => {
    if (step.move.kind !== "rapid") {
      const now = stockAfter(i + 1);
      if (now !== stocks.at(-1)) stocks.push(now);
    }
    for (const to of pointsTo(step)) {
      time +=
        (Math.hypot(to.z - here.z, to.r - here.r) / (step.move.kind === "rapid" ? SHOWN.rapid : SHOWN.feed)) * 1000;
      way.push([Math.round(time), rounded(to.z), rounded(to.r), stocks.length - 1, passOf(step)]);
      const line = `M${thumbPlace(here)}L${thumbPlace(to)}`;
      if (step.move.kind === "rapid") rapids += line;
      else feeds += line;
      here = to;
    }
  });
  const { plane, hatch } = unstatedClamping(
    made.blank,
    boundsOf(made.blank.flat()) ?? { left: 0, right: 0, low: 0, high: 0 },
  );
  const insert = insertOutline(operation.tool, FINE);
  const seen = [...made.blank.flat(), ...hatch.flat(), ...way.map(([, z, r]) => ({ z, r }) as Pt)];
  return {
    cycle: operation.cycle,
    box: thumbBox(seen),
    held: [plane, ...hatch].map(([from, to]) => `M${thumbPlace(from)}L${thumbPlace(to)}`).join(""),
    stocks,
    insert: drawn([insert]),
    rapids,
    feeds,
    way,
    passes: operation.plan.passes,
    infeed: operation.plan.infeed,
    seconds: Math.round(made.seconds),
    proved: verdictOf(made, simulation).verdict === "proved",
  };
}

/** The pictures of programs on the start page: computed when the page is built. */
export function startPictures(): StartPictures {
  const examples = Object.entries(FILES).flatMap(([id, file]) => {
    const made = thumbnail(file);
    return made ? [[id, made] as const] : [];
  });
  return { live: live(LIVE), examples: Object.fromEntries(examples) };
}

/** The module that the page imports by the name in src/features/start/start-pictures.d.ts, by its id. */
export const pictureModules = (): Readonly<Record<string, string>> => ({
  "virtual:start-pictures": `export const pictures = ${JSON.stringify(startPictures())};`,
});
