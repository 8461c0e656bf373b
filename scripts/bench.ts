import { spawnSync } from "node:child_process";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import type { FinishedPart } from "../src/planning/part/finished-part.ts";
import { planning } from "../src/planning/plan.ts";
import type { PlanRequest } from "../src/planning/types.ts";
import type { SetJob } from "../src/program/job/job.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { quantile } from "../e2e/pages/measure.ts";
import type { Simulation } from "../src/sim/simulation.ts";
import { simulate, incrementalSimulator } from "../src/sim/simulate.ts";
import { stockAt } from "../src/sim/stock.ts";
import { ringData } from "../src/view/path.ts";
import { sceneOf } from "../src/view/scene.ts";
import { partOfTrade } from "../tests/planning/parts.ts";
import { requestOf } from "../tests/planning/plan-laws.ts";
import { changedAt, changedOperations, PLACES, planningAgain } from "./bench-again.ts";
import { longContour, printedExample } from "./long-contour.ts";
import { grownProgram, type largePrograms } from "./large-programs.ts";
import { longProgram } from "./long-program.ts";
import { longShaft } from "./long-shaft.ts";
import { markdownTable, writeIntoPage } from "./performance-page.ts";
import { middle, REFERENCE, referenceTime } from "./reference.ts";
import { verified } from "./verify.ts";

/** Milliseconds; `ratio` is the median in units of the reference loop, which ran before and after it. */
interface Measured {
  readonly median: number;
  readonly p95: number;
  readonly n: number;
  readonly ratio: number;
}

/** A repeated measurement with its least and greatest number of rounds, limited by time. */
interface BenchCase {
  readonly name: string;
  /** Gets a growing count, so that no result can be cached. */
  readonly work: (count: number) => unknown;
  /** Number of warm-up rounds, and the least number of counted rounds. */
  readonly least: number;
}

/** Time limit of one measurement, ms, and its least and greatest number of rounds. */
const PATIENCE = 4000;
const [LEAST, MOST] = [20, 400];

const rounded = (value: number) => Number(value.toFixed(3));

/** Relates times to the reference loop, which is slowed by other load on the machine in the same way. */
function beside(times: () => readonly number[]): Measured {
  const before = referenceTime(),
    sorted = [...times()].sort((a, b) => a - b),
    reference = middle([before, referenceTime()]);
  const median = quantile(sorted, 0.5);
  return {
    median: rounded(median),
    p95: rounded(quantile(sorted, 0.95)),
    n: sorted.length,
    ratio: rounded(median / reference),
  };
}

function timed(work: () => unknown): number {
  const began = performance.now();
  work();
  return performance.now() - began;
}

/** Repeats a case after an uncounted warm-up. */
const measured = ({ work, least }: BenchCase): Measured =>
  beside(() => {
    const times: number[] = [];
    let count = 0;
    for (; count < least; count += 1) work(count);
    const end = performance.now() + PATIENCE;
    const goesOn = () => times.length < least || (times.length < MOST && performance.now() < end);
    for (; goesOn(); count += 1) times.push(timed(() => work(count)));
    return times;
  });

const labels = ncLabels("en");
/** The same job with a slightly different oversize in Z: a real edit, another text and another path each time. */
const changed = (job: SetJob, count: number): SetJob => {
  const draft = job.drafts[job.cycle] ?? {};
  return { ...job, drafts: { [job.cycle]: { ...draft, Q484: (0.1 + (count % 200) * 0.001).toFixed(3) } } };
};
const planned = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const stock = (text: string) => {
  const made = planned(text);
  return { made, simulation: simulate(made) };
};
/** From a changed value to everything on screen: text, moves, stock, proof, picture. */
const update = (job: SetJob, count: number) => {
  const { made, simulation } = stock(printJob(changed(job, count), labels));
  const scene = sceneOf({
    blank: made.blank,
    clamping: made.clamping,
    contours: made.operations.map((o) => o.plan.contour),
    steps: made.steps,
  });
  return [scene, ringData(simulation.final)];
};

/** Size of a grown program. */
const GROWN = { operations: 100, moves: 50_000 };
/** Least number of rounds for cases that take seconds. */
const FEW = 2;

const benchCase = (name: string, work: BenchCase["work"], least = LEAST): BenchCase => ({ name, work, least });
const planText = (text: string) => () => run(parse(text), { tools: shippedTools, rapid: 10_000 });

function* printedCases(): Generator<BenchCase> {
  for (const cycle of [810, 812, 820, 852]) {
    const job = printedExample(cycle);
    const program = parse(printJob(job, labels));
    yield benchCase(`plan ${cycle}`, () => run(program, { tools: shippedTools, rapid: 10_000 }));
    yield benchCase(`update ${cycle}`, (count) => update(job, count));
    yield benchCase(`verify ${cycle}`, (count) =>
      verified("example.h", printJob(changed(job, count), labels), { tools: shippedTools, refused: new Map() }),
    );
  }
}

const seekIn = (name: string, text: () => string): BenchCase => {
  let made: Simulation | null = null;
  return benchCase(name, (count) => {
    made ??= stock(text()).simulation;
    return stockAt(made, { step: (count * 7919) % made.steps.length, fraction: (count % 10) / 10 });
  });
};

/**
 * Large cases: contours of 1,000 elements, and 100 operations with 50,000 moves, from scratch and changed at the last
 * operation.
 */
function* grownCases(): Generator<BenchCase> {
  const [across, along] = [820, 810].map((cycle) => printJob(longContour(cycle, 1000), labels));
  if (across === undefined || along === undefined) return;
  const [long, other] = [parse(across), parse(along)];
  yield benchCase("plan 820 1000", () => run(long, { tools: shippedTools, rapid: 10_000 }));
  yield benchCase("plan 810 1000", () => run(other, { tools: shippedTools, rapid: 10_000 }));
  yield benchCase("stock 820 1000", () => stock(across));
  yield seekIn("seek 820", () => printJob(printedExample(820), labels));
  yield seekIn("seek 820 1000", () => across);
  const grown = grownProgram(GROWN.operations, GROWN.moves);
  yield benchCase("plan grown", planText(grown), FEW);
  yield benchCase("stock grown", () => stock(grown), FEW);
  for (const [where, place] of PLACES) {
    const plan = planningAgain(),
      proved = incrementalSimulator();
    yield benchCase(`plan grown, ${where} changed`, (count) => plan(changedAt(grown, place, count)), FEW);
    yield benchCase(`stock grown, ${where} changed`, (count) => proved(plan(changedAt(grown, place, count))), FEW);
  }
  yield seekIn("seek grown", () => grown);
  const both = [0, 1].map((count) => planText(changedAt(grown, 1, count))());
  yield benchCase(
    "picture grown",
    (count) => {
      const made = both[count % 2];
      return (
        made &&
        sceneOf({
          blank: made.blank,
          clamping: made.clamping,
          contours: made.operations.map((o) => o.plan.contour),
          steps: made.steps,
        })
      );
    },
    FEW,
  );
}

/** Parts whose working plans are measured: of the trade, and one of many features. */
const PLANNED_PARTS: readonly (readonly [name: string, part: FinishedPart])[] = [
  ...["shaft", "pulley", "piston"].map((name) => [name, partOfTrade(name)] as const),
  ["long shaft", longShaft()],
];

/** A search up to its first whole plan, or to its end. */
function searched(request: PlanRequest, toFirst: boolean): void {
  const search = planning(request);
  for (let next = search.next(); !next.done; next = search.next()) if (toFirst && next.value.isWhole) return;
}

function* workingPlans(): Generator<BenchCase> {
  for (const [name, part] of PLANNED_PARTS) {
    const request = requestOf(part);
    if (!request) throw new Error(name);
    yield benchCase(`working plan ${name}, first`, () => searched(request, true), FEW);
    yield benchCase(`working plan ${name}`, () => searched(request, false), FEW);
  }
}

function* allCases(): Generator<BenchCase> {
  const program10000 = longProgram(10_000);
  yield benchCase("parse 10000", () => parse(program10000));
  yield* printedCases();
  yield* grownCases();
  for (const [name, work] of changedOperations()) yield benchCase(name, work);
  yield* workingPlans();
}

/** All cases whose names contain a word, or all. */
function measureAll(word: string): Record<string, Measured> {
  const results: Record<string, Measured> = {};
  const program10000 = longProgram(10_000);
  // Before any warm-up, as when the first file is opened.
  if (word === "") results["parse 10000 cold"] = beside(() => [timed(() => parse(program10000))]);
  for (const each of allCases()) if (each.name.includes(word)) results[each.name] = measured(each);
  return results;
}

/** Programs at the size limits, each measured in a process of its own. */
const LARGE = [
  "10 MB of cuts",
  "10 MB of milling",
  "10 MB of nonsense",
  "200,000 blocks",
  "400,000 moves",
  "10,000 passes",
  "loop of cycles",
  "contour of 20,000 elements",
] as const satisfies readonly (keyof typeof largePrograms)[];

/** Processor time in ms from text to report, and the peak memory of its process in MB. */
interface Large {
  readonly parsed: number;
  readonly ran: number;
  readonly simulated: number;
  readonly reported: number;
  readonly mbReport: number;
  readonly steps: number;
  readonly plane: number;
  readonly verdict: string;
}

/** One program alone in a process limited to the memory of a tablet; null when it needs more. */
function large(name: (typeof LARGE)[number]): Large | null {
  const done = spawnSync(process.execPath, ["--max-old-space-size=800", "scripts/run.mjs", "large", name], {
    encoding: "utf8",
  });
  return done.status === 0 ? (JSON.parse(done.stdout) as Large) : null;
}

const FRAME = 16;
/** Limits of the median, ms, by the beginning of the name; all other cases must fit in one frame. */
const LIMITS: readonly (readonly [string, number])[] = [
  ["working plan shaft, first", 200],
  ["working plan", 3000],
  ["parse", 50],
  ["verify", 30],
  ["plan 820 1000", 50],
  ["plan 810 1000", 50],
  ["plan grown, ", FRAME],
  ["plan grown", 1000],
  ["plan", 5],
  ["stock grown, first", 10_000],
  ["stock grown, middle", 10_000],
  ["stock grown, ", 500],
  ["stock grown", 10_000],
  ["picture grown", 100],
  ["stock", 250],
];
const limit = (name: string) => LIMITS.find(([begin]) => name.startsWith(begin))?.[1] ?? FRAME;

function resultRow([name, each]: readonly [string, Measured]): readonly string[] {
  const most = limit(name) / REFERENCE,
    kept = each.ratio <= most ? most.toFixed(2) : `${most.toFixed(2)}, missed`;
  return [
    name,
    each.median.toFixed(2),
    each.p95.toFixed(2),
    String(each.n),
    each.ratio.toFixed(2),
    kept,
    String(limit(name)),
  ];
}

/**
 * `npm run bench`: a table of times; with --json one object on one line. `--only=WORD` measures the cases whose names
 * contain the word, without the programs at the size limits; `--write` also updates docs/performance.md.
 */
export function main(args: readonly string[]): number {
  const only = args.find((arg) => arg.startsWith("--only="))?.slice("--only=".length) ?? "";
  const results = measureAll(only);
  const bounds = only === "" ? LARGE.map((name) => [name, large(name)] as const) : [];
  const reference = rounded(referenceTime());
  if (args.includes("--json")) {
    console.log(JSON.stringify({ reference, ...results, large: Object.fromEntries(bounds) }));
    return 0;
  }
  const lines = [
    `The reference loop takes ${reference.toFixed(2)} ms here, Node ${process.version}:`,
    "",
    ...markdownTable(
      1,
      ["", "median ms", "p95 ms", "n", "ratio", "limit of ratio", "limit ms"],
      Object.entries(results).map(resultRow),
    ),
  ];
  const atBounds =
    bounds.length === 0
      ? []
      : markdownTable(
          1,
          ["at the bounds", "parse ms", "run ms", "simulate ms", "report ms", "moves", "MB"],
          bounds.map(([name, m]) => [
            name,
            ...(m ? [m.parsed, m.ran, m.simulated, m.reported, m.steps + m.plane, m.mbReport].map(String) : ["failed"]),
          ]),
        );
  console.log([...lines, "", ...atBounds].join("\n"));
  if (args.includes("--write") && only === "") {
    writeIntoPage("bench", lines);
    writeIntoPage("bounds", atBounds);
  }
  return bounds.every(([, m]) => m !== null) ? 0 : 1;
}
