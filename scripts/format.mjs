/**
 * `npm run format` writes every source file as the formatter does; with `--check`, as the lint stage runs it, it changes
 * nothing and names the files that differ and the lines that are longer than a reader can take in.
 */
import { createFromBuffer } from "@dprint/formatter";
import { getPath } from "@dprint/typescript";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./packages.mjs";

/** Longest line, in characters. */
const LINE = 140;
const formatter = createFromBuffer(readFileSync(getPath()));
formatter.setConfig({ lineWidth: LINE, indentWidth: 2, newLineKind: "lf" }, {
  "quoteStyle": "preferDouble",
  "quoteProps": "preserve",
  "trailingCommas": "onlyMultiLine",
  "nextControlFlowPosition": "sameLine",
  "useBraces": "maintain",
  "singleBodyPosition": "maintain",
  "arrowFunction.useParentheses": "force",
  // What fits on a line stands on one; only an object keeps the lines its author gave it.
  "preferSingleLine": true,
  "objectExpression.preferSingleLine": false,
  // What does not fit is filled line by line; only an object gets a line for each of its members.
  "preferHanging": true,
  "objectExpression.preferHanging": false,
  "arguments.preferHanging": "always",
  "arrayExpression.preferHanging": "never",
  "parameters.preferHanging": "onlySingleItem",
  // The order of imports is the author's.
  "module.sortImportDeclarations": "maintain",
  "module.sortExportDeclarations": "maintain",
  "importDeclaration.sortNamedImports": "maintain",
  "exportDeclaration.sortNamedExports": "maintain",
});

/** Printed tables, whose rows are as wide as the control writes them. */
const TABLES = ["src/program/tools/tool-table.test.ts"];

/** The text as it stays when it is formatted again: some breaks settle in the second round only. */
function settled(file, text) {
  for (let round = 0, before = text; round < 5; round++) {
    const after = formatter.formatText({ filePath: file, fileText: before });
    if (after === before) return after;
    before = after;
  }
  throw new Error(`${file} looks different every time it is formatted`);
}

const check = process.argv.includes("--check");
const listed = execFileSync("git", ["ls-files", "-co", "--exclude-standard", "*.ts", "*.tsx", "*.mjs", "*.js"], {
  cwd: root,
  encoding: "utf8",
});
const faults = [];
let written = 0;
for (const file of new Set(listed.split("\n").filter((name) => name !== "" && existsSync(join(root, name))))) {
  const text = readFileSync(join(root, file), "utf8");
  const formatted = settled(file, text);
  if (formatted !== text && check) faults.push(`${file} is not formatted: npm run format does it`);
  if (formatted !== text && !check) writeFileSync(join(root, file), formatted);
  if (formatted !== text) written++;
  if (TABLES.includes(file)) continue;
  formatted.split("\n").forEach((line, at) => {
    if ([...line].length > LINE) faults.push(`${file}:${at + 1} is longer than ${LINE} characters`);
  });
}
if (!check) console.log(`${written} files formatted`);
for (const fault of faults) console.error(fault);
if (faults.length > 0) process.exitCode = 1;
