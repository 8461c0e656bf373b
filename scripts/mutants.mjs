/**
 * `npm run mutants [-- --write] [WORD …]`: plants each fault of tests/mutants/*.json in a copy of the tree, one at a
 * time, and runs there the tests that its entry names. A fault that these do not detect survives, and the command
 * fails; it also fails when the text of a fault is no longer in its file. WORD selects faults by file or description.
 * `--write` puts the counts of a run of all into docs/verification.md.
 */
import { fork } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative } from "node:path";
import { ensurePackages, root } from "./packages.mjs";

const args = process.argv.slice(2);
/** Number of parallel copies. */
const SIDE_BY_SIDE = Number(process.env.JOBS ?? 2);
/** Timeout of a run, s: a fault that makes a path endless counts as detected. */
const PATIENCE = Number(process.env.PATIENCE ?? 300);

/**
 * In a copy: one Vitest for all faults, since starting it takes longer than most tests. Answers each list of tests with
 * the first test that fails, or null.
 */
async function serveTests() {
  const { createVitest } = await import("vitest/node");
  const base = process.cwd();
  let failure = null;
  const found = (module, test) => {
    failure ??= { file: relative(base, module.moduleId), test };
    void vitest.cancelCurrentRun("test-failure");
  };
  const reporter = {
    onTestCaseResult: (test) => test.result().state === "failed" && found(test.module, test.fullName),
    onTestModuleEnd: (module) => module.state() === "failed" && found(module, "does not run at all"),
  };
  const vitest = await createVitest("test", { watch: false, reporters: [reporter], maxWorkers: 1 });
  process.on("message", async ({ planted, tests }) => {
    failure = null;
    planted.forEach((path) => vitest.invalidateFile(join(base, path)));
    const specifications = await vitest.globTestSpecifications(tests);
    const { unhandledErrors } = await vitest.runTestSpecifications(specifications);
    if (specifications.length === 0 || unhandledErrors.length > 0)
      failure ??= { file: tests[0], test: "does not run at all" };
    process.send(failure);
  });
  // Also what never ends goes with the one who asked for it.
  process.on("disconnect", () => process.kill(0, "SIGKILL"));
  process.send("ready");
}

const KINDS = ["unit", "law", "golden"];
const kindOf = (file) =>
  /^src|validation|catalogue|messages/.test(file)
    ? "unit"
    : /printed|verify|goldens|tests\/cases/.test(file)
      ? "golden"
      : "law";

/** A copy of the tree with a process that runs tests in it. */
class Copy {
  base = mkdtempSync(join(tmpdir(), "turnwise-mutants-"));
  /** Files that are not what they were in the last run. */
  changed = new Set();
  child = null;

  constructor() {
    const left = new Set(["node_modules", "dist", ".git", "test-results", "playwright-report", "coverage"]);
    cpSync(root, this.base, { recursive: true, filter: (path) => !left.has(relative(root, path).split(/[\\/]/)[0]) });
    symlinkSync(join(root, "node_modules"), join(this.base, "node_modules"), "junction");
  }

  /** What the process says next; one that says nothing for too long is ended with all that it started. */
  answer() {
    const { child } = this;
    return new Promise((resolve) => {
      const end = (said) => {
        clearTimeout(patience);
        child.removeAllListeners();
        resolve(said);
      };
      const patience = setTimeout(() => this.stop(), PATIENCE * 1000);
      child.once("message", end);
      child.once("exit", () => {
        this.child = null;
        end("does not end");
      });
    });
  }

  stop() {
    const { pid } = this.child ?? {};
    if (pid) process.kill(process.platform === "win32" ? pid : -pid, "SIGKILL");
  }

  /** The first of these tests that fails, or null. */
  async firstFailure(tests) {
    if (!this.child) {
      const env = { ...process.env, CI: "true", LAW_SEED: process.env.LAW_SEED ?? "1", SEED: "1" };
      // A group of its own, so that no test process outlives it.
      this.child = fork(join(this.base, "scripts", "mutants.mjs"), ["--serve"], {
        cwd: this.base,
        detached: true,
        stdio: "ignore",
        env,
      });
      await this.answer();
    }
    this.child.send({ planted: [...this.changed], tests });
    this.changed.clear();
    const said = await this.answer();
    return said === "does not end" ? { file: tests[0], test: said } : said;
  }

  /** The first test that detects a fault, or null. */
  async tried({ file, find, replace, tests }) {
    const path = join(this.base, file);
    const text = readFileSync(path, "utf8");
    writeFileSync(
      path,
      text.replace(find, () => replace),
    );
    this.changed.add(file);
    const failure = await this.firstFailure(tests);
    writeFileSync(path, text);
    this.changed.add(file);
    return failure;
  }

  remove() {
    this.stop();
    rmSync(this.base, { recursive: true, force: true });
  }
}

/** Writes how many faults of each list were found, and by what, into docs/verification.md. */
function write(results, total) {
  const groups = [...new Set(results.map(({ group }) => group))].sort();
  const rows = groups.map((group) => {
    const of = results.filter((r) => r.group === group);
    const found = KINDS.map((kind) => of.filter((r) => r.failure && kindOf(r.failure.file) === kind).length);
    return `| \`${group}.json\` | ${[of.length, ...found, of.filter((r) => !r.failure).length].join(" | ")} |`;
  });
  const table = [
    "<!-- mutants: written by npm run mutants -- --write -->",
    "",
    `${total}.`,
    "",
    "| List in `tests/mutants/` | Faults | Found by unit tests | By laws | By goldens alone | Survive |",
    "|---|---|---|---|---|---|",
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

async function main() {
  ensurePackages();
  const words = args.filter((a) => !a.startsWith("--"));
  const folder = join(root, "tests", "mutants");
  /** The faults: `find` is in `file` exactly once, and `tests` must detect the fault. */
  const all = readdirSync(folder)
    .sort()
    .flatMap((name) =>
      JSON.parse(readFileSync(join(folder, name), "utf8")).map((m) => ({ ...m, group: name.replace(".json", "") })),
    );
  const chosen = all.filter((m) => words.every((w) => `${m.group} ${m.file} ${m.what}`.includes(w)));
  const stale = all.flatMap((m) => {
    const count = readFileSync(join(root, m.file), "utf8").split(m.find).length - 1;
    return count === 1 ? [] : [`${m.what}: the text stands ${count} times in ${m.file}`];
  });
  if (stale.length > 0) throw new Error(stale.join("\n"));

  const results = [];
  const copies = Array.from({ length: Math.min(SIDE_BY_SIDE, chosen.length) }, () => new Copy());
  try {
    // Without a fault everything must pass, or every fault would seem to be detected.
    const needed = [...new Set(chosen.flatMap((m) => m.tests))];
    await Promise.all(
      copies.map(async (copy, i) => {
        const own = needed.filter((_, n) => n % copies.length === i);
        // Without names of files Vitest would run all of them.
        const clean = own.length > 0 ? await copy.firstFailure(own) : null;
        if (clean) throw new Error(`the tests fail without a fault: ${clean.file}: ${clean.test}`);
      }),
    );
    const waiting = chosen.values();
    await Promise.all(
      copies.map(async (copy) => {
        for (const m of waiting) {
          const failure = await copy.tried(m);
          results.push({ ...m, failure });
          console.log(
            failure
              ? `${kindOf(failure.file).padEnd(8)} ${m.what} (${m.file}): ${failure.file}: ${failure.test.slice(0, 100)}`
              : `SURVIVED ${m.what} (${m.file})`,
          );
        }
      }),
    );
  } finally {
    for (const copy of copies) copy.remove();
  }
  results.sort((a, b) => all.findIndex((m) => m.what === a.what) - all.findIndex((m) => m.what === b.what));
  const survivors = results.filter((r) => !r.failure);
  const byGolden = results.filter((r) => r.failure && kindOf(r.failure.file) === "golden");
  const total = `${results.length} faults, ${survivors.length} survive, ${byGolden.length} are seen by goldens alone`;
  console.log(total);
  if (args.includes("--write") && results.length === all.length) write(results, total);
  process.exitCode = survivors.length > 0 || byGolden.length * 2 > results.length ? 1 : 0;
}

await (args.includes("--serve") ? serveTests() : main());
