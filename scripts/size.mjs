/**
 * Fails when the first load has grown past its limit: all JavaScript that index.html reaches by static imports, the worker
 * it starts, and the largest of the languages, compressed as a server sends it.
 */
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { gzipSync } from "node:zlib";
import { root } from "./packages.mjs";

/** kB of 1000 bytes, compressed. */
const LIMIT = 250;

const dist = join(root, "dist");
const read = (path) => readFileSync(join(dist, path), "utf8");
const found = (text, pattern) => [...text.matchAll(pattern)].map(([, path]) => path);

const seen = new Map();
function visit(path) {
  if (seen.has(path)) return;
  const text = read(path);
  seen.set(path, gzipSync(text).length);
  const beside = [
    ...found(text, /(?:^|[;}\s])(?:import|export)\s*(?:[\w$*{][^"';]*?from\s*)?["'](\.[^"']+\.js)["']/g),
    ...found(text, /new URL\(\s*(?:\/\*[^*]*\*\/\s*)?["'`]([^"'`]+\.js)["'`]\s*,\s*(?:""\s*\+\s*)?import\.meta\.url/g),
  ];
  for (const next of beside) visit(next.startsWith("/") ? next.slice(1) : normalize(join(dirname(path), next)));
}
const page = read("index.html");
for (const path of found(page, /<(?:script|link)[^>]+(?:src|href)="\.?\/?([^"]+\.js)"/g)) visit(path);
const languages = readdirSync(join(dist, "assets")).filter((name) => /^(de|en|fr|zh)-[\w-]+\.js$/.test(name)).map((name) =>
  `assets/${name}`
);
const weight = (path) => gzipSync(read(path)).length;
const largest = languages.sort((a, b) => weight(b) - weight(a))[0];

const worker = readdirSync(join(dist, "assets")).find((name) => /^worker-[\w-]+\.js$/.test(name));
if (!worker) throw new Error("The worker is not where it is looked for.");
visit(`assets/${worker}`);

if (seen.size === 0) throw new Error("index.html loads no script: build first.");
if (!largest) throw new Error("The languages are not where they are looked for.");
visit(largest);
for (const [path, bytes] of seen) console.log(`${(bytes / 1000).toFixed(1).padStart(7)} kB  ${path}`);
const total = [...seen.values()].reduce((sum, bytes) => sum + bytes, 0) / 1000;
console.log(`${total.toFixed(1).padStart(7)} kB  first load, limit ${LIMIT} kB`);
if (total > LIMIT) process.exitCode = 1;
