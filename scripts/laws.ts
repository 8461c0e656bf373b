import { spawn } from "node:child_process";
import { writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import fc from "fast-check";
import { cuttingCycles, cycleByNumber } from "../src/cycles/index.ts";
import { brokenBy } from "../tests/laws/cut-laws.ts";
import { brokenByEdit, edits, unedited } from "../tests/laws/edited-programs.ts";
import { movingPrograms } from "../tests/laws/moving-programs.ts";
import type { FoundCase } from "../tests/laws/found-case.ts";
import { brokenByPlan } from "../tests/laws/plan-laws.ts";
import { situations } from "../tests/laws/situation.ts";
import { arbitraryParts } from "../tests/planning/arbitrary-part.ts";
import { brokenByPart, leftThoughReached, planOf, requestOf } from "../tests/planning/plan-laws.ts";
import { markdownTable, writeIntoPage } from "./performance-page.ts";
import { handTable, PLAN_COLUMNS, tradeRows, type PlanRow } from "../tests/planning/plan-tables.ts";
import { wayTable } from "../tests/better-ways/way-table.ts";

/** Machining operations (Q215), and the number of set-ups for one process. */
const OPERATIONS = [0, 1, 2, 3];
const SHARE = 250;

/** Set-ups of one operation of one cycle. */
interface Job {
  readonly cycle: number;
  readonly operation: number;
  readonly cases: number;
  readonly seed: number;
}
/** The result: every set-up that breaks a law. */
interface Outcome {
  readonly tried: number;
  readonly found: readonly FoundCase[];
}

/** The set-ups of one operation of a cycle; a thread has only one. */
const drawnFor = (number: number, operation: number) => situations(operation).find((s) => s.cycle.number === number);

/**
 * Draws set-ups and checks each against the laws. Failing set-ups are not shrunk: at a contour that takes longer than
 * drawing thousands more.
 */
function tried({ cycle: number, operation, cases, seed }: Job): Outcome {
  const cycle = cycleByNumber(number);
  const drawn = drawnFor(number, operation);
  if (!cycle || !drawn) throw new Error(`no cycle ${number}`);
  const found = fc.sample(drawn.arbitrary, { numRuns: cases, seed }).flatMap((situation): FoundCase[] => {
    const said = [...brokenByPlan(cycle, situation), ...brokenBy(cycle, situation)];
    return said.length > 0 ? [{ cycle: number, said, situation }] : [];
  });
  return { tried: cases, found };
}

/** Runs a job in a process of its own. */
function inProcess(job: Job): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [...process.argv.slice(1, 3), "--job", JSON.stringify(job)], {
      stdio: ["ignore", "pipe", "inherit"],
    });
    let out = "";
    child.stdout.on("data", (data: Buffer) => (out += data.toString()));
    child.on("exit", (code) =>
      code === 0 ? resolve(JSON.parse(out) as Outcome) : reject(new Error(`a process ended with ${code}`)),
    );
  });
}

const option = (args: readonly string[], name: string, otherwise: number) => {
  const given = args.find((a) => a.startsWith(`--${name}=`));
  return given ? Number(given.slice(name.length + 3)) : otherwise;
};

/** Plans random parts and prints those whose plan breaks a law. Returns 1 if there was one. */
function plannedParts(cases: number, seed: number): number {
  let bad = 0;
  fc.sample(arbitraryParts, { numRuns: cases, seed }).forEach(({ part, features }, i) => {
    const request = requestOf(part);
    const plan = request && planOf(request);
    const said = request && plan ? [...brokenByPart(request, plan), ...leftThoughReached(request, plan)] : [];
    if (said.length > 0) bad += 1;
    if (said.length > 0) console.log(`part ${i} (${features.join(", ")}): ${said.join("; ")}`);
  });
  console.log(`${cases} parts planned, ${bad} broken`);
  return bad > 0 ? 1 : 0;
}

/** Edits of one program. */
const EDITS_OF_PROGRAM = 12;

/**
 * Edits random programs and prints the first difference of each between its incremental calculation and that of the
 * edited program alone. Returns 1 if there was one.
 */
function editedPrograms(count: number, seed: number): number {
  const drawn = fc.tuple(movingPrograms, fc.array(edits, { minLength: EDITS_OF_PROGRAM, maxLength: EDITS_OF_PROGRAM }));
  const cases = fc.sample(drawn, { numRuns: Math.ceil(count / EDITS_OF_PROGRAM), seed });
  let bad = 0;
  cases.forEach(([text, changes], i) => {
    const broken = brokenByEdit(unedited(text), changes);
    if (!broken) return;
    bad += 1;
    console.log(`program ${i}, edit ${broken.edit} ${JSON.stringify(changes[broken.edit - 1])}:\n${broken.text}`);
    const at = [...broken.kept].findIndex((c, k) => c !== broken.alone[k]);
    if (at < 0) console.log("the reports are equal, run or simulation are not");
    else for (const each of [broken.kept, broken.alone]) console.log(each.slice(Math.max(0, at - 200), at + 100));
  });
  console.log(`${cases.length * EDITS_OF_PROGRAM} edits of ${cases.length} programs, ${bad} broken`);
  return bad > 0 ? 1 : 0;
}

/** Plans the parts of the trade. Returns 1 if a step of a plan was not prepared by those before it. */
function trade(writes: boolean): number {
  const rows: PlanRow[] = [];
  let bad = 0;
  for (const { row, ms, unprepared } of tradeRows()) {
    rows.push(row);
    console.log([...row, `${ms.toFixed(0)} ms`, ...unprepared].join(" | "));
    bad += unprepared.length;
  }
  if (writes) writeIntoPage("plans", markdownTable(5, PLAN_COLUMNS, rows), "docs/planning.md");
  else for (const line of handTable()) console.log(line);
  return bad > 0 ? 1 : 0;
}

/**
 * `npm run laws -- --parts=N [-- --seed=N]`: plans N random parts and checks the laws of plans.
 * `npm run laws -- --edits=N [-- --seed=N]`: edits random programs N times and compares the incremental calculation with
 * that of the edited program alone.
 * `npm run laws -- --trade`: plans the parts of the trade and those programmed by hand and prints their times; with
 * `--write` only the former, which are written into docs/planning.md.
 * `npm run laws -- --ways[=NAME] [--in-turn]`: prints what is suggested for the course's solutions, the examples and
 * ordinary programs, checks each suggestion, and takes them one after the other.
 * `npm run laws [-- --cases=N] [-- --seed=N] [-- --cycle=N]`: draws N set-ups of each cycle (10,000), cuts each twice
 * and checks every law. A set-up that breaks a law is written to tests/laws/found, where `npm test` tries it from then
 * on. Returns 1 if there was one.
 */
export async function main(args: readonly string[]): Promise<number> {
  if (args[0] === "--job") {
    process.stdout.write(JSON.stringify(tried(JSON.parse(args[1] ?? "") as Job)));
    return 0;
  }
  if (args.includes("--trade")) {
    return trade(args.includes("--write"));
  }
  const ways = args.find((a) => a.startsWith("--ways"));
  if (ways !== undefined) {
    let last = "";
    for (last of wayTable(ways.slice("--ways=".length), args.includes("--in-turn"))) console.log(last);
    return last.startsWith("0 ") ? 0 : 1;
  }
  const seed = option(args, "seed", Number(process.env["LAW_SEED"] ?? Date.now() % 2 ** 31));
  const edited = option(args, "edits", 0);
  if (edited > 0) {
    console.log(`LAW_SEED=${seed}, ${edited} edits`);
    return editedPrograms(edited, seed);
  }
  const parts = option(args, "parts", 0);
  if (parts > 0) {
    console.log(`LAW_SEED=${seed}, ${parts} parts`);
    return plannedParts(parts, seed);
  }
  const [cases, only] = [option(args, "cases", 10_000), option(args, "cycle", 0)];
  console.log(`LAW_SEED=${seed}, ${cases} set-ups of each cycle`);
  const each = Math.ceil(cases / OPERATIONS.length);
  const jobs = cuttingCycles
    .filter((c) => only === 0 || c.number === only)
    .flatMap(({ number }) =>
      OPERATIONS.filter((operation) => drawnFor(number, operation)).flatMap((operation) =>
        Array.from({ length: Math.ceil(each / SHARE) }, (_, i): Job => ({
          cycle: number,
          operation,
          cases: Math.min(SHARE, each - i * SHARE),
          seed: (seed + i * 7919) % 2 ** 31,
        })),
      ),
    );
  const table = new Map<string, { tried: number; broken: number }>();
  const waiting = [...jobs];
  let bad = 0;
  await Promise.all(
    Array.from({ length: Math.min(availableParallelism(), jobs.length) }, async () => {
      for (let job = waiting.shift(); job; job = waiting.shift()) {
        const { tried: count, found } = await inProcess(job);
        const row = `${job.cycle} Q215=${job.operation}`;
        const before = table.get(row) ?? { tried: 0, broken: 0 };
        table.set(row, { tried: before.tried + count, broken: before.broken + found.length });
        bad += found.length;
        found.forEach((one, i) => {
          const path = join(
            "tests",
            "laws",
            "found",
            `${job.cycle}-${job.operation}-${job.seed}${i > 0 ? `-${i + 1}` : ""}.json`,
          );
          writeFileSync(path, `${JSON.stringify(one)}\n`);
          console.log(`${path}: ${one.said.join("; ")}`);
        });
      }
    }),
  );
  console.log("| cycle | set-ups | broken |\n|---|---:|---:|");
  for (const [row, { tried: count, broken }] of [...table].sort()) console.log(`| ${row} | ${count} | ${broken} |`);
  return bad > 0 ? 1 : 0;
}
