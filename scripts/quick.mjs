/**
 * `npm run quick`: the inner loop, for every few minutes of work. Types, lint of the files that changed since the last
 * commit, and the nearby tests, with few random cases. With no change, uses the files of the last commit.
 */
import { execFileSync, spawn } from "node:child_process";
import { join } from "node:path";
import { ensurePackages, root } from "./packages.mjs";

ensurePackages();
const git = (...args) => execFileSync("git", args, { cwd: root, encoding: "utf8" }).split("\n");
const isCode = (file) => /^(src|tests|scripts)\/.*\.tsx?$/.test(file);
const changed = [
  ...git("diff", "--name-only", "--diff-filter=d", "HEAD"),
  ...git("ls-files", "--others", "--exclude-standard"),
].filter(isCode);
const files =
  changed.length > 0 ? changed : git("show", "--name-only", "--diff-filter=d", "--format=", "HEAD").filter(isCode);

const cache = join(root, "node_modules", ".cache", "turnwise");
const bin = (...path) => join(root, "node_modules", ...path);
/** The folders of the nearest tests of a file: its own, and for the kernel also the cycles. */
function nearest(file) {
  const [top, layer, feature] = file.split("/");
  if (top !== "src") return [file.endsWith(".test.ts") ? file : `tests/architecture.test.ts`];
  if (layer === "app" || layer === "features") return [`src/${layer}/${feature}`];
  return layer === "kernel" ? ["src/kernel", "src/cycles"] : [`src/${layer}`];
}
const tests = [...new Set(files.flatMap(nearest))];
const work = [
  ["types", bin("typescript", "bin", "tsc"), "-b"],
  files.length > 0 && [
    "lint",
    bin("eslint", "bin", "eslint.js"),
    "--max-warnings",
    "0",
    "--cache",
    "--cache-location",
    join(cache, "eslint"),
    ...files,
  ],
  tests.length > 0 && ["tests", bin("vitest", "vitest.mjs"), "run", "--passWithNoTests", ...tests],
].filter(Boolean);

const results = await Promise.all(
  work.map(
    ([name, ...args]) =>
      new Promise((resolve) => {
        const began = performance.now();
        const child = spawn(process.execPath, args, {
          cwd: root,
          stdio: ["ignore", "inherit", "inherit"],
          env: { ...process.env, LAW_CASES: "3", LAW_RUNS: "50" },
        });
        child.on("exit", (code) => {
          console.log(`${code === 0 ? "ok  " : "FAIL"} ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
          resolve(code === 0);
        });
      }),
  ),
);
process.exitCode = results.every(Boolean) ? 0 : 1;
