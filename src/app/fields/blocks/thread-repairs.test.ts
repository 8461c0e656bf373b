import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { engine } from "../../calculation/engine.ts";
import { isError } from "../../findings/entry.ts";
import { findingsOf } from "../../findings/findings.ts";
import { parse } from "../../../nc/parse.ts";
import { print } from "../../../nc/program.ts";
import { NC_OUTPUTS } from "../../../program/machine/nc-output.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { statementsInUnit } from "../../../program/edits/program-unit.ts";
import { withBlock } from "../../../nc/edit.ts";
import { repairsOf } from "./repairs.ts";

const findingsIn = (text: string) =>
  findingsOf(
    null,
    engine.update({
      version: 1,
      text,
      table: { tools: shippedTools, mills: [], refused: new Map() },
      rapid: 10_000,
      control: "TNC 640",
    }),
  );
const overrunIn = (text: string) => findingsIn(text).find(({ issue }) => issue.code === "threadOverruns");

const caseText = (name: string) => readFileSync(`tests/cases/${name}.h`, "utf8");

/** A shaft of ⌀20 before a shoulder, with a thread up to a Z. */
const toShoulder = (end: string) =>
  caseText("thread-flank-at-shoulder")
    .replace(/28 UDC THREAD PITCH2\n/, "")
    .replace("Q494=-27.5", `Q494=${end}`);

/** The same program in inches. */
function inInches(text: string): string {
  const program = parse(text);
  const statements = statementsInUnit(
    program.blocks.map(({ statement }) => statement),
    true,
    true,
  );
  return statements
    .reduce((made, s, i) => print(withBlock(parse(made), i, s)), text)
    .replace(/(BEGIN|END) PGM (\w+) MM/g, "$1 PGM $2 INCH")
    .replace(/D40 L80/, `D${(40 / 25.4).toFixed(4)} L${(80 / 25.4).toFixed(4)}`);
}

/** Of each group the first repair whose run has no error, as the page offers it. */
function cures(text: string): Record<string, string | number> {
  const program = parse(text);
  const found = overrunIn(text);
  const helpful: Record<string, string | number> = {};
  for (const { trial = "", text: value, next } of found ? repairsOf(program, found, "en", NC_OUTPUTS.manual) : []) {
    if (trial in helpful) continue;
    const after = findingsIn(print(next()));
    if (after.every((entry) => entry.issue.code !== "threadOverruns" && !isError(entry))) helpful[trial] = value;
  }
  return helpful;
}

test.each([
  ["with its flank in the relief", caseText("thread-flank-at-shoulder"), { endThread: "Z-26.5" }],
  ["on the shaft", caseText("thread-end-no-run-out"), { runOut: "Q474 2", endThread: "Z-24" }],
  ["at a shoulder", toShoulder("-30"), { endThread: "Z-26", relief: "Z-26" }],
])("a thread that ends %s has cures, and each leaves no overrun", (_, text, expected) => {
  expect(cures(text)).toEqual(expected);
});

test("in an inch program a cure has inches, and leaves no overrun", () => {
  const text = inInches(toShoulder("-30"));
  const found = overrunIn(text);
  const repairs = found ? repairsOf(parse(text), found, "en", NC_OUTPUTS.manual) : [];
  const relief = repairs.find(({ trial, text: value }) => trial === "relief" && value === "Z-1.0236");
  expect(relief && overrunIn(print(relief.next()))).toBeUndefined();
  expect(relief?.open).toBeGreaterThan(0);
});
