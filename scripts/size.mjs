/**
 * Fails when the page is larger than its limits: in bytes as `scripts/serve.mjs` sends them, and in requests. Two sums,
 * each with the largest language: all that the start page fetches by itself, and all that the dialog of a cycle cannot
 * work without, with the check in the worker.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync } from "node:zlib";
import { root } from "./packages.mjs";

/** kB of 1000 bytes, and requests. */
const LIMITS = { first: { kB: 200, requests: 25 }, dialog: { kB: 520, requests: 30 } };

const dist = join(root, "dist");
const read = (path) => readFileSync(join(dist, path));
const known = new Map();
/** Bytes of a file on the wire: fonts are packed already. */
function weight(path) {
  if (!known.has(path)) {
    const packed = path.endsWith(".woff2") ? read(path) : brotliCompressSync(read(path));
    known.set(path, packed.length);
  }
  return known.get(path);
}
const manifest = JSON.parse(read(".vite/manifest.json")),
  modules = JSON.parse(read(".vite/modules.json"));

/** A chunk of the build by its name in the manifest, or by a module in it. */
function part(name) {
  const found = manifest[name] ?? Object.values(manifest).find(({ file }) => file === modules[name]);
  if (!found) throw new Error(`The build has no ${name}: build first, and keep the names of this script in step.`);
  return found;
}

/** Files of a chunk and of all its static imports, with their style sheets. */
function filesOf(name, seen = new Set()) {
  const { file, imports = [], css = [] } = part(name);
  if (seen.has(file)) return seen;
  seen.add(file);
  for (const sheet of css) seen.add(sheet);
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

/** What the page itself names: scripts, style sheets, fonts, icon, manifest. */
const named = [
  ...read("index.html")
    .toString()
    .matchAll(/(?:href|src)="\.\/([^"]+)"/g),
].map(([, path]) => path);
const first = new Set([
  "index.html",
  // A picture for the home screen of a telephone: fetched when the page is put there.
  ...named.filter((path) => !path.includes("apple-touch-icon")),
  ...filesOf("index.html"),
  ...union([
    "virtual:start-pictures",
    "src/features/start/Hero.tsx",
    "src/features/course/CourseEntrance.tsx",
    "src/app/fields/keypad/NumberKeys.tsx",
    "src/app/records/keep-steps.ts",
    "src/app/records/keep-pictures.ts",
    "src/app/records/files/kept-handles.ts",
    "src/app/base/styles/print.css",
  ]),
  ...largest((l) => [
    `virtual:cycle-menu/${l}`,
    ...["first", "parts", "course"].map((name) => `src/i18n/${l}/${name}.ts`),
  ]),
]);
const dialog = new Set([
  ...first,
  ...union(["src/features/start/begin.ts", "src/shell/Workplace.tsx", "src/app/calculation/worker.ts"]),
  ...largest((l) => [`virtual:cycle-menu/${l}`, `src/i18n/${l}/workplace.ts`]),
]);

const kB = (bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB`;
for (const file of dialog) console.log(`${kB(weight(file))}  ${first.has(file) ? "first  " : "dialog "} ${file}`);
for (const [name, files, limit] of [
  ["first load", first, LIMITS.first],
  ["until a dialog works", dialog, LIMITS.dialog],
]) {
  console.log(`${kB(sum(files))}, ${files.size} requests  ${name}, limit ${limit.kB} kB, ${limit.requests} requests`);
  if (sum(files) / 1000 > limit.kB || files.size > limit.requests) process.exitCode = 1;
}
