import { spawnSync } from "node:child_process";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import type { SetJob } from "../src/program/job.ts";
import { printJob } from "../src/program/print-job.ts";
import { run } from "../src/program/run.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";
import { simulate } from "../src/sim/simulate.ts";
import { stockAt } from "../src/sim/stock.ts";
import { ringData } from "../src/view/path.ts";
import { sceneOf } from "../src/view/scene.ts";
import { changedOperations } from "./bench-again.ts";
import { longContour, printedExample } from "./long-contour.ts";
import type { largePrograms } from "./large-programs.ts";
import { longProgram } from "./long-program.ts";
import { verified } from "./verify.ts";

/** Milliseconds. */
interface Measured {
  readonly median: number;
  readonly p95: number;
  readonly n: number;
}

/** How long one measurement goes on at most, and how often it is repeated at least and at most. */
const PATIENCE = 4000;
const [LEAST, MOST] = [20, 400];

/** Repeats with a warm-up that is not counted. `work` is given a count that grows, so that no result can be kept. */
function measured(work: (count: number) => unknown): Measured {
  const times: number[] = [];
  let count = 0;
  for (; count < LEAST; count += 1) work(count);
  for (const end = performance.now() + PATIENCE; times.length < LEAST || (times.length < MOST && performance.now() < end); count += 1) {
    const began = performance.now();
    work(count);
    times.push(performance.now() - began);
  }
  times.sort((a, b) => a - b);
  const at = (part: number) => Number((times[Math.min(times.length - 1, Math.floor(part * times.length))] ?? 0).toFixed(3));
  return { median: at(0.5), p95: at(0.95), n: times.length };
}

const labels = ncLabels("en");
/** The same job with its oversize in Z changed a little: a real edit, another text and another path each time. */
const changed = (job: SetJob, count: number): SetJob => {
  const draft = job.drafts[job.cycle] ?? {};
  return { ...job, drafts: { [job.cycle]: { ...draft, Q484: (0.1 + (count % 200) * 0.001).toFixed(3) } } };
};
const planned = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const stock = (text: string) => {
  const made = planned(text);
  return { made, simulation: simulate(made) };
};
/** From a changed value to everything that is drawn: text, moves, stock, proof, picture. */
const update = (job: SetJob, count: number) => {
  const { made, simulation } = stock(printJob(changed(job, count), labels));
  const scene = sceneOf({ blank: made.blank, contours: made.operations.map((o) => o.plan.contour), steps: made.steps });
  return [scene, ringData(simulation.final)];
};

function all(): Record<string, Measured> {
  const results: Record<string, Measured> = {};
  const program10000 = longProgram(10_000);
  // Before anything has warmed up, as when a file is opened first.
  const began = performance.now();
  parse(program10000);
  const cold = Number((performance.now() - began).toFixed(3));
  results["parse 10000 cold"] = { median: cold, p95: cold, n: 1 };
  results["parse 10000"] = measured(() => parse(program10000));
  for (const cycle of [810, 812, 820, 852]) {
    const job = printedExample(cycle);
    const program = parse(printJob(job, labels));
    results[`plan ${cycle}`] = measured(() => run(program, { tools: shippedTools, rapid: 10_000 }));
    results[`update ${cycle}`] = measured((count) => update(job, count));
    results[`verify ${cycle}`] = measured((count) =>
      verified("example.h", printJob(changed(job, count), labels), { tools: shippedTools, refused: new Map() })
    );
  }
  const long = parse(printJob(longContour(820, 1000), labels));
  const along = parse(printJob(longContour(810, 1000), labels));
  const longText = printJob(longContour(820, 1000), labels);
  results["plan 820 1000"] = measured(() => run(long, { tools: shippedTools, rapid: 10_000 }));
  results["plan 810 1000"] = measured(() => run(along, { tools: shippedTools, rapid: 10_000 }));
  results["stock 820 1000"] = measured(() => stock(longText));
  for (const [name, job] of [["seek 820", printedExample(820)], ["seek 820 1000", longContour(820, 1000)]] as const) {
    const { simulation } = stock(printJob(job, labels));
    results[name] = measured((count) =>
      stockAt(simulation, { step: (count * 7919) % simulation.steps.length, fraction: (count % 10) / 10 })
    );
  }
  for (const [name, work] of changedOperations()) results[name] = measured(work);
  return results;
}

/** Programs at the bounds that are measured, each in a process of its own. */
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

/** Processor time in ms from text to report, and the highest memory of its process in MB. */
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

/** One program alone in a process that may use no more memory than a tablet has; null when it needs more. */
function large(name: (typeof LARGE)[number]): Large | null {
  const done = spawnSync(process.execPath, ["--max-old-space-size=800", "scripts/run.mjs", "large", name], { encoding: "utf8" });
  return done.status === 0 ? (JSON.parse(done.stdout) as Large) : null;
}

/** What each time may be at most, ms (median), by how its name begins; every other one is a frame. */
const LIMITS: readonly (readonly [string, number])[] = [["parse", 50], ["verify", 30], ["plan 820 1000", 50], ["plan", 5], ["stock", 250]];
const FRAME = 16;
const limit = (name: string) => LIMITS.find(([begin]) => name.startsWith(begin))?.[1] ?? FRAME;

/** `npm run bench`: a table of times; with --json one object on one line. */
export function main(args: readonly string[]): number {
  const results = all();
  const bounds = LARGE.map((name) => [name, large(name)] as const);
  if (args.includes("--json")) {
    console.log(JSON.stringify({ ...results, large: Object.fromEntries(bounds) }));
    return 0;
  }
  const row = (cells: readonly string[]) => `| ${cells.map((c, i) => (i === 0 ? c.padEnd(28) : c.padStart(9))).join(" | ")} |`;
  console.log(row(["", "median ms", "p95 ms", "n", "limit ms"]));
  console.log("|---|---:|---:|---:|---:|");
  for (const [name, { median, p95, n }] of Object.entries(results))
    console.log(row([name, median.toFixed(2), p95.toFixed(2), String(n), String(limit(name))]));
  console.log();
  const wide = (cells: readonly string[]) => `| ${cells.map((c, i) => (i === 0 ? c.padEnd(26) : c.padStart(9))).join(" | ")} |`;
  console.log(wide(["at the bounds, ms", "parse", "run", "simulate", "report", "moves", "MB"]));
  console.log("|---|---:|---:|---:|---:|---:|---:|");
  for (const [name, m] of bounds)
    console.log(wide([name, ...(m ? [m.parsed, m.ran, m.simulated, m.reported, m.steps + m.plane, m.mbReport].map(String) : ["failed"])]));
  return bounds.every(([, m]) => m !== null) ? 0 : 1;
}
