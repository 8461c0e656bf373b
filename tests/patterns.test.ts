import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { projectPath } from "./sources.ts";

const GROWING = [
  String.raw`/\s+$/`,
  String.raw`/^\s*\/?\s*x/`,
  String.raw`/^(a+)+$/`,
  String.raw`/^(a|a)*$/`,
  String.raw`/^(a*)*b/`,
  String.raw`/<[^>]*>/`,
  String.raw`/\d+\.?\d*x/`,
  String.raw`/^\s*x/m`,
  String.raw`/a(?=.*b)/g`,
  String.raw`/\d+(?![\d.])/`,
  String.raw`/;.*$/`,
  String.raw`const S = "\\s*"; new RegExp(S + S + "x")`,
  "const S = String.raw`[ ]*`; RegExp(`^${S}${S}$`)",
];
const LINEAR = [
  String.raw`/\s+/g`,
  String.raw`/^\s+/`,
  String.raw`/(?<!\s)\s+$/`,
  String.raw`/^\s*(?:\/\s*)?x/`,
  String.raw`/(?<!\d)\d+(?![\d.])/`,
  String.raw`/\b\w+x/`,
  String.raw`/^[ \t]*x/m`,
  String.raw`/;.*/`,
  String.raw`/^\d{1,9}\d?x/`,
  String.raw`/"[^"]*"?/`,
  String.raw`new RegExp(text)`,
];

const ALL = [...GROWING, ...LINEAR];
const folder = mkdtempSync(join(tmpdir(), "patterns-"));
/** The lines that the rule refuses: one run of the linter reads each as a file. */
let refused: ReadonlySet<string> = new Set();

beforeAll(() => {
  const config = join(folder, "config.json");
  const jsPlugins = [projectPath("scripts/lint/own.mjs")];
  const rules = { "own/linear-patterns": "error" };
  writeFileSync(config, JSON.stringify({ jsPlugins, categories: { correctness: "off" }, rules }));
  ALL.forEach((line, i) => writeFileSync(join(folder, `${i}.js`), line));
  const linter = projectPath("node_modules/oxlint/bin/oxlint");
  const { stdout } = spawnSync(process.execPath, [linter, "-c", config, "--format", "json", folder], {
    encoding: "utf8",
  });
  const { diagnostics } = JSON.parse(stdout) as { diagnostics: readonly { readonly filename: string }[] };
  refused = new Set(diagnostics.map(({ filename }) => ALL[parseInt(basename(filename), 10)] ?? filename));
});
afterAll(() => rmSync(folder, { recursive: true }));

test.each(GROWING)("grows: %s", (line) => {
  expect(refused).toContain(line);
});

test.each(LINEAR)("is linear: %s", (line) => {
  expect(refused).not.toContain(line);
});
