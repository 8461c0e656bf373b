/**
 * `npm run quick`: the inner loop, for every few minutes of work. Types, lint of the files that changed since the last
 * commit, and the tests nearest to them, with few random cases. With no change, uses the files of the last commit.
 */
import { execFileSync, spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join, posix } from "node:path";
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

const bin = (...path) => join(root, "node_modules", ...path);
/** Tests that run at most: those of a file of the kernel are nearly all. One with a document takes as long as three. */
const MOST_TESTS = 8;
const WITH_DOCUMENT = 3;

/** For each file of src and tests, the files that import it. */
function importers() {
  const all = git("ls-files", "--cached", "--others", "--exclude-standard", "src", "tests").filter(isCode);
  const found = new Map(all.map((file) => [file, []]));
  for (const file of all.filter((each) => existsSync(join(root, each))))
    for (const [, path] of readFileSync(join(root, file), "utf8").matchAll(/(?:from|import|import\() ?"(\.[^"]+)"/g))
      found.get(posix.join(posix.dirname(file), path))?.push(file);
  return found;
}

/** Rooms of src from the lowest, which the others are built on. */
const ROOMS = ["kernel", "nc", "cycles", "program", "sim", "view", "planning", "course", "report", "app", "features"];

/** How near a test is to a file: by the folders they share, then the lower room. */
function distance(test, file) {
  const [one, other] = [test.split("/"), file.split("/")];
  const shared = one.findIndex((part, i) => part !== other[i]);
  const room = ROOMS.indexOf(one[1]);
  return (room < 0 ? ROOMS.length : room) - shared * (ROOMS.length + 1);
}

/** The tests beside the code that depend on one of the files, the nearest first; not those of the whole page. */
function nearest(from) {
  const by = importers();
  const of = (file) => {
    const seen = new Set([file]);
    for (const each of seen) for (const importer of by.get(each) ?? []) seen.add(importer);
    const room = file.startsWith("src/shell/") ? /^src\// : /^src\/(?!shell)/;
    const isTest = (each) => /\.test\.tsx?$/.test(each) && (room.test(each) || each === file);
    return [...seen].filter(isTest).map((test) => ({ test, far: distance(test, file) }));
  };
  const all = from.flatMap(of).sort((a, b) => a.far - b.far);
  let left = MOST_TESTS;
  return [...new Set(all.map(({ test }) => test))].filter((test) => {
    const takes = test.endsWith("x") ? WITH_DOCUMENT : 1;
    if (takes > left) return false;
    left -= takes;
    return true;
  });
}
const tests = files.length > 0 ? nearest(files) : [];
const work = [
  ["types", bin("typescript-native", "bin", "tsc"), "-b"],
  files.length > 0 && ["lint", bin("oxlint", "bin", "oxlint"), ...files],
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
