/**
 * `npm run mutants [-- --write] [WORD …]`: plants each fault of tests/mutants/*.json in a copy of the tree, one at a
 * time, and runs the fast tests there. A fault that no test detects survives, and the command fails; it also fails when
 * the text of a fault is no longer in its file. WORD selects faults by file or description. `--write` puts the table
 * into docs/verification.md.
 */
import { spawn } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative } from "node:path";
import { ensurePackages, root } from "./packages.mjs";

const args = process.argv.slice(2);
const words = args.filter((a) => !a.startsWith("--"));
const WRITE = args.includes("--write");
/** Number of parallel copies, and cases per law: a fault that only thousands of cases reveal counts as a survivor. */
const SIDE_BY_SIDE = Number(process.env.JOBS ?? 2);
const LAW_CASES = process.env.LAW_CASES ?? "10";
/** Timeout of a run, s: a fault that makes a path endless counts as detected. */
const PATIENCE = Number(process.env.PATIENCE ?? 600);

/** Test folders in order; goldens last, since a golden says that something changed and not what is right. */
const STAGES = [
  {
    kind: "unit",
    tests: [
      "src/kernel",
      "src/cycles",
      "src/sim",
      "src/program",
      "src/nc",
      "src/report",
      "tests/validation.test.ts",
      "tests/catalogue.test.ts",
      "tests/messages.test.ts",
    ],
  },
  {
    kind: "law",
    tests: [
      "tests/laws",
      "tests/judge",
      "tests/job-laws.test.ts",
      "tests/examples.test.ts",
      "tests/adapted-tools.test.ts",
    ],
  },
  {
    kind: "golden",
    tests: ["tests/cases", "tests/goldens.test.ts", "tests/printed-examples.test.ts", "tests/verify.test.ts"],
  },
];

const folder = join(root, "tests", "mutants");
/** The faults: `find` is in `file` exactly once. `tests` run first, because they test that place. */
const all = readdirSync(folder)
  .filter((name) => name.endsWith(".json"))
  .sort()
  .flatMap((name) =>
    JSON.parse(readFileSync(join(folder, name), "utf8")).map((m) => ({ ...m, group: name.replace(".json", "") })),
  );
const chosen = all.filter((m) => words.every((w) => `${m.group} ${m.file} ${m.what}`.includes(w)));

function planted(base, { file, find, replace }) {
  const path = join(base, file);
  const text = readFileSync(path, "utf8");
  if (text.split(find).length !== 2)
    throw new Error(`${file}: "${find}" stands ${text.split(find).length - 1} times, not once`);
  writeFileSync(
    path,
    text.replace(find, () => replace),
  );
  return () => writeFileSync(path, text);
}

function copied() {
  const base = mkdtempSync(join(tmpdir(), "turnwise-mutants-"));
  const left = new Set(["node_modules", "dist", ".git", "test-results", "playwright-report", "coverage"]);
  cpSync(root, base, { recursive: true, filter: (source) => !left.has(relative(root, source).split(/[\\/]/)[0]) });
  symlinkSync(join(root, "node_modules"), join(base, "node_modules"), "junction");
  return base;
}

/** Runs tests in a copy; the first test that fails, or null. */
function firstFailure(base, tests) {
  const report = join(base, "mutant.json");
  rmSync(report, { force: true });
  const cli = join(base, "node_modules", "vitest", "vitest.mjs");
  const child = spawn(
    process.execPath,
    [cli, "run", ...tests, "--bail=1", "--reporter=json", `--outputFile.json=${report}`, "--passWithNoTests"],
    {
      cwd: base,
      stdio: "ignore",
      env: { ...process.env, CI: "true", LAW_CASES, LAW_SEED: process.env.LAW_SEED ?? "1", SEED: "1" },
    },
  );
  let patient = true;
  const patience = setTimeout(() => {
    patient = false;
    child.kill("SIGKILL");
  }, PATIENCE * 1000);
  return new Promise((resolve) =>
    child.on("exit", (code) => {
      clearTimeout(patience);
      if (!patient) return resolve({ file: tests[0], test: "does not end" });
      if (code === 0) return resolve(null);
      let [file, test] = ["?", "does not run at all"];
      try {
        for (const suite of JSON.parse(readFileSync(report, "utf8")).testResults) {
          const bad = suite.assertionResults.find((t) => t.status === "failed");
          if (!bad && suite.status !== "failed") continue;
          [file, test] = [relative(base, suite.name), bad?.fullName ?? "does not run at all"];
          if (bad) break;
        }
      } catch {
        // A run without a report counts as failed.
      }
      resolve({ file, test });
    }),
  );
}

/** The first test that detects a fault, one list of tests after another, or null. */
async function tried(base, mutant, lists) {
  const restore = planted(base, mutant);
  try {
    for (const tests of lists) {
      const failure = await firstFailure(base, tests);
      if (failure) return failure;
    }
    return null;
  } finally {
    restore();
  }
}

const kindOf = (file) =>
  file.startsWith("src") || /validation|catalogue|messages/.test(file)
    ? "unit"
    : /laws|judge|course|examples\.test|adapted/.test(file) && !/printed/.test(file)
      ? "law"
      : "golden";

ensurePackages();
const stale = all.flatMap((m) => {
  const count = readFileSync(join(root, m.file), "utf8").split(m.find).length - 1;
  return count === 1 ? [] : [`${m.what}: the text stands ${count} times in ${m.file}`];
});
if (stale.length > 0) {
  console.error(stale.join("\n"));
  process.exit(1);
}

const results = [];
const bases = Array.from({ length: Math.min(SIDE_BY_SIDE, chosen.length) }, copied);
/** Tries faults in parallel and returns those that no test detected; `tests` is every test that may run for them. */
async function round(mutants, tests, listsOf) {
  if (mutants.length === 0) return [];
  // Without a fault everything must pass, or every fault would seem to be detected.
  const clean = await firstFailure(bases[0], tests);
  if (clean) throw new Error(`the tests fail without a fault: ${clean.file}: ${clean.test}`);
  const [waiting, unseen] = [[...mutants], []];
  await Promise.all(
    bases.map(async (base) => {
      for (let m = waiting.shift(); m; m = waiting.shift()) {
        const failure = await tried(base, m, listsOf(m));
        if (!failure) {
          unseen.push(m);
          continue;
        }
        results.push({ ...m, failure });
        console.log(
          `${kindOf(failure.file).padEnd(8)} ${m.what} (${m.file}): ${failure.file}: ${failure.test.slice(0, 100)}`,
        );
      }
    }),
  );
  return unseen;
}

try {
  // Most faults are detected by the tests for their place; only the others need all tests.
  const near = chosen.filter((m) => m.tests);
  const unseen = await round(near, [...new Set(near.flatMap((m) => m.tests))], (m) => [m.tests]);
  const lists = STAGES.map((s) => s.tests);
  for (const m of await round([...chosen.filter((m) => !m.tests), ...unseen], lists.flat(), () => lists)) {
    results.push({ ...m, failure: null });
    console.log(`SURVIVED ${m.what} (${m.file})`);
  }
} finally {
  for (const base of bases) rmSync(base, { recursive: true, force: true });
}

results.sort((a, b) => all.findIndex((m) => m.what === a.what) - all.findIndex((m) => m.what === b.what));
const survivors = results.filter((r) => !r.failure);
const byGolden = results.filter((r) => r.failure && kindOf(r.failure.file) === "golden");
const total = `${results.length} faults, ${survivors.length} survive, ${byGolden.length} are seen by goldens alone`;
console.log(total);
if (WRITE) {
  const cell = (text) => text.replaceAll("|", "\\|");
  const rows = results.map(
    (r) =>
      `| ${cell(r.what)} | \`${r.file.replace("src/", "")}\` | ` +
      (r.failure ? `${kindOf(r.failure.file)}: \`${r.failure.file}\`` : "**survives**") +
      " |",
  );
  const table = [
    "<!-- mutants: written by npm run mutants -- --write -->",
    "",
    `${total}.`,
    "",
    "| Fault | Where | Killed by |",
    "|---|---|---|",
    ...rows,
    "",
    "<!-- /mutants -->",
  ].join("\n");
  const path = join(root, "docs", "verification.md");
  writeFileSync(
    path,
    readFileSync(path, "utf8").replace(/<!-- mutants:[\s\S]*<!-- \/mutants -->/, () => table),
  );
}
process.exitCode = survivors.length > 0 || byGolden.length * 2 > results.length ? 1 : 0;
