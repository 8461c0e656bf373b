/**
 * Fails when the page is larger than its limits, compressed as a server sends it. Two sums, each with the largest
 * language: all JavaScript of the first screen, and everything that is fetched until the dialog of a cycle works,
 * including its calculation in the worker.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { root } from "./packages.mjs";

/** kB of 1000 bytes, compressed. */
const LIMITS = { first: 150, dialog: 520 };

const dist = join(root, "dist");
const read = (path) => readFileSync(join(dist, path), "utf8");
const weight = (path) => gzipSync(read(path)).length;
const manifest = JSON.parse(read(".vite/manifest.json")),
  modules = JSON.parse(read(".vite/modules.json"));

/** A chunk of the build by its name in the manifest, or by a module in it. */
function part(name) {
  const found = manifest[name] ?? Object.values(manifest).find(({ file }) => file === modules[name]);
  if (!found) throw new Error(`The build has no ${name}: build first, and keep the names of this script in step.`);
  return found;
}

/** Files of a chunk and of all its static imports. */
function filesOf(name, seen = new Set()) {
  const { file, imports = [] } = part(name);
  if (seen.has(file)) return seen;
  seen.add(file);
  for (const next of imports) filesOf(next, seen);
  return seen;
}
const sum = (files) => [...files].reduce((total, file) => total + weight(file), 0);
const union = (names) => new Set(names.flatMap((name) => [...filesOf(name)]));

const languages = Object.keys(modules).flatMap((name) => /^src\/i18n\/(\w+)\/first\.ts$/.exec(name)?.[1] ?? []);
/** The language with the largest texts. */
function largest(namesOf) {
  const sets = languages.map((language) => union(namesOf(language)));
  return sets.sort((a, b) => sum(b) - sum(a))[0];
}

const first = new Set([
  ...filesOf("index.html"),
  ...largest((l) => [`virtual:cycle-menu/${l}`, `src/i18n/${l}/first.ts`]),
]);
const dialog = new Set([
  ...first,
  ...union(["src/features/start/begin.ts", "src/shell/Workplace.tsx", "src/app/calculation/worker.ts"]),
  ...largest((l) => [`src/i18n/${l}/parts.ts`, `src/i18n/${l}/workplace.ts`, `virtual:cycle-menu/${l}`]),
]);

const kB = (bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB`;
for (const file of dialog) console.log(`${kB(weight(file))}  ${first.has(file) ? "first  " : "dialog "} ${file}`);
for (const [name, files, limit] of [
  ["first load", first, LIMITS.first],
  ["until a dialog works", dialog, LIMITS.dialog],
]) {
  console.log(`${kB(sum(files))}  ${name}, limit ${limit} kB`);
  if (sum(files) / 1000 > limit) process.exitCode = 1;
}
