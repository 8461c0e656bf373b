/**
 * `npm test`: installs missing packages, then checks types and style and builds, then runs unit tests with goldens and
 * laws, the size check and the e2e tests in Chromium. Stops after the first failing stage; the last line counts passed
 * and failed tests.
 */
import { spawn } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { ensureBrowser } from "./browser.mjs";
import { ensurePackages, root } from "./packages.mjs";

/** Formatted files, as in `npm run format`. */
const SOURCES = "**/*.{ts,tsx,mjs,js}";
const results = join(root, "node_modules", ".cache", "turnwise");
const bin = (...path) => join(root, "node_modules", ...path);

/** Counts of one report file; a missing report counts as zero. */
function counted(file, count) {
  try {
    return count(JSON.parse(readFileSync(file, "utf8")));
  } catch {
    return { passed: 0, failed: 0 };
  }
}
const unitReport = join(results, "unit.json");
const journeyReport = join(results, "journeys.json");
const unitCount = () => counted(unitReport, (r) => ({ passed: r.numPassedTests, failed: r.numFailedTests }));
/** An e2e test that passes on retry counts as passed; Playwright lists it as flaky, above. */
const journeyCount = () =>
  counted(journeyReport, (r) => ({ passed: r.stats.expected + r.stats.flaky, failed: r.stats.unexpected }));

const unit = [
  bin("vitest", "vitest.mjs"),
  "run",
  "--reporter=default",
  "--reporter=json",
  `--outputFile.json=${unitReport}`,
];

/**
 * Stages run one after another; the commands of one stage in parallel on all cores, the longest first. The e2e tests
 * run alone.
 */
const stages = [
  [
    // Each checker works out the shared types again; the other core builds meanwhile.
    { name: "types", args: [bin("typescript-native", "bin", "tsc"), "-b", "--checkers", "1"] },
    { name: "build", args: [bin("vite", "bin", "vite.js"), "build", "--logLevel", "warn"] },
    { name: "lint", args: [bin("oxlint", "bin", "oxlint"), "."] },
    { name: "format", args: [bin("oxfmt", "bin", "oxfmt"), "--list-different", SOURCES] },
    { name: "a Chromium is here", args: [join(root, "scripts", "browser.mjs")] },
  ],
  [{ name: "unit tests, goldens and laws", count: unitCount, args: unit }],
  [{ name: "size", args: [join(root, "scripts", "size.mjs")] }],
  [
    {
      name: "journeys in Chromium",
      count: journeyCount,
      browser: true,
      args: [bin("@playwright", "test", "cli.js"), "test"],
    },
  ],
];

function run({ name, args, browser }) {
  const began = performance.now();
  const env = {
    ...process.env,
    CI: "true",
    PLAYWRIGHT_JSON_OUTPUT_FILE: journeyReport,
    ...(browser ? { CHROMIUM_PATH: ensureBrowser() } : {}),
  };
  const child = spawn(process.execPath, args, { cwd: root, env, stdio: ["ignore", "inherit", "inherit"] });
  return new Promise((resolve) =>
    child.on("exit", (code) => {
      const seconds = ((performance.now() - began) / 1000).toFixed(1);
      console.log(`${code === 0 ? "ok  " : "FAIL"} ${name} (${seconds} s)`);
      resolve(code === 0);
    }),
  );
}

/** Whether each command of a stage succeeded, in order. */
async function runAll(commands) {
  const good = [];
  const waiting = commands.entries();
  const runNext = async () => {
    for (const [i, command] of waiting) good[i] = await run(command);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, runNext));
  return good;
}

ensurePackages();
mkdirSync(results, { recursive: true });
for (const file of [unitReport, journeyReport]) rmSync(file, { force: true });
let passed = 0;
let failed = 0;
for (const stage of stages) {
  const good = await runAll(stage);
  stage.forEach(({ count }, i) => {
    const here = count?.() ?? { passed: 0, failed: 0 };
    passed += here.passed;
    failed += Math.max(here.failed, good[i] ? 0 : 1);
  });
  if (failed > 0) break;
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
