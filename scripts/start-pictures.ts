import { readFileSync } from "node:fs";
import { join } from "node:path";
import { runningPass } from "../src/features/start/running-pass.ts";
import type { ExampleId } from "../src/examples/index.ts";
import { parse } from "../src/nc/parse.ts";
import { print, type Program } from "../src/nc/program.ts";
import { withClamping } from "../src/program/clamping/draft.ts";
import type { ClampingDraft } from "../src/program/clamping/words.ts";
import type { Run } from "../src/program/state/run-types.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { verdictOf } from "../src/report/verdict.ts";
import type { Simulation } from "../src/sim/simulation.ts";
import { simulate } from "../src/sim/simulate.ts";
import { boundsOf } from "../src/view/bounds.ts";
import { positionAt, trackOf } from "../src/view/playback.ts";
import { planeThumbnailOf, thumbnailOf, type Thumbnail } from "../src/view/thumbnail.ts";
import { stillPicture } from "./start-still.ts";

const RAPID = 10_000;
/** The program of the hero, and the files of the examples. Runs in the project folder. */
const HERO = "shaft";
const FILES: Readonly<Record<ExampleId, string>> = {
  shaft: "shaft",
  flange: "flange",
  shoulder: "shoulder",
  contour: "contour",
  contourEnglish: "contour-en",
  groove: "groove",
  plate: "plate",
};

const programOf = (file: string) => parse(readFileSync(join("src", "examples", `${file}.h`), "utf8"));
const runOf = (program: Program): Run => run(program, { tools: shippedTools, rapid: RAPID });

const rounded = (v: number) => Math.round(v * 100) / 100;

/** The finished part of a program; null where nothing is turned. */
const thumbnail = (made: Run, simulation?: Simulation): Thumbnail | null =>
  made.operations.length === 0
    ? planeThumbnailOf(made.plane, made.cuboid)
    : thumbnailOf(made.blank, (simulation ?? simulate(made)).final);

/** The hero is turned in a chuck, so that jaws and tool holder show as on a machine. */
const CLAMPED: ClampingDraft = { kind: "chuckOutside", words: { D: "90", LENGTH: "20", FACE: "-108", SIZE: "160" } };
/** Where its still picture stands, as a share of the run: in the middle of roughing. */
const STILL = 0.19;
/** Room round the part, as shares of its length: beyond its end and above it for the tool. */
const AIR = { left: 0.02, right: 0.1, over: 0.15, under: 0.04 };

/** A program that is played on the start page: its text, its facts, and its picture before it has run. */
function hero(text: string, made: Run, simulation: Simulation) {
  const box = boundsOf(made.blank.flat());
  if (!box) throw new Error("The program of the hero has no blank");
  const long = box.right - box.left;
  const frame = {
    left: rounded(box.left - AIR.left * long),
    right: rounded(box.right + AIR.right * long),
    low: rounded(-box.high - AIR.under * long),
    high: rounded(box.high + AIR.over * long),
  };
  const track = trackOf(made.steps);
  const at = positionAt(track, STILL * track.total);
  return {
    text,
    frame,
    at,
    running: runningPass(made, at.step),
    operations: made.operations.length,
    tools: new Set(made.operations.map(({ tool }) => tool.T)).size,
    seconds: Math.round(made.seconds),
    proved: verdictOf(made, simulation).verdict === "proved",
    still: stillPicture(made, simulation, at, frame),
  };
}

/** The pictures of programs on the start page: computed when the page is built. */
function startPictures() {
  const text = print(withClamping(programOf(HERO), CLAMPED));
  const made = runOf(parse(text));
  const simulation = simulate(made);
  const examples = Object.entries(FILES).flatMap(([id, file]) => {
    const drawn = file === HERO ? thumbnail(made, simulation) : thumbnail(runOf(programOf(file)));
    return drawn ? [[id, drawn] as const] : [];
  });
  return { hero: hero(text, made, simulation), examples: Object.fromEntries(examples) };
}

/**
 * The modules that the page imports by the names in src/features/start/start-pictures.d.ts, by their ids. What is not
 * shown at once, or in one theme only, has its own.
 */
export function pictureModules(): Readonly<Record<string, string>> {
  const id = "virtual:start-pictures";
  const { hero, examples } = startPictures();
  const { text, still, ...facts } = hero;
  const made = (name: string, value: unknown) => `export const ${name} = ${JSON.stringify(value)};`;
  return {
    [id]: made("pictures", { hero: { ...facts, box: still.box }, examples }),
    [`${id}/light`]: made("drawing", still.light),
    [`${id}/dark`]: made("drawing", still.dark),
    [`${id}/program`]: made("text", text),
  };
}
