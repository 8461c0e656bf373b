import { expect, test } from "vitest";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { findingsOf } from "../findings/findings.ts";
import { shownVerdict } from "../findings/verdict.ts";
import { verdictReasons, verdictTitle } from "../findings/verdict-words.ts";
import { findingsShown, isDefinedIn } from "../document/shown-findings.ts";
import { filesOf, type ProgramWork } from "../document/work.ts";
import { findings as words } from "../../i18n/en/workplace/findings.ts";
import { engine } from "./engine.ts";
import { isMadeFrom } from "./outcome.ts";

const HEAD =
  "BLK FORM CYLINDER Z D63.4 L90 DIST+0\nFUNCTION MODE TURN\nTOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500\nM136\n" +
  "L X+95 Z+52 R0 FMAX\n";
const pgm = (lines: string) => `BEGIN PGM S MM\n${lines}\nEND PGM S MM\n`;
const CYCLE =
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~\nQ215=+0 ~\nQ460=+2 ~\nQ493=+41.27 ~\nQ494=-33.85 ~\nQ463=+2.35 ~\nQ478=+0.3 ~\nQ483=+0.5 ~\n" +
  "Q484=+0.15 ~\nQ505=+0.2 ~\nQ506=+0";

const work = (lines: string, files: Readonly<Record<string, string>> = {}, skipMarked = false): ProgramWork => ({
  name: "MAIN.H",
  text: pgm(`${HEAD}${lines}\nM30`),
  encoding: "utf-8",
  files: Object.entries(files).map(([name, text]) => ({ name, text, encoding: "utf-8" })),
  skipMarked,
});
const update = ({ name, text, files = [], skipMarked = false }: ProgramWork) =>
  engine.update({
    version: 1,
    name,
    text,
    files,
    skipMarked,
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  });

test("the other files of a program are run as it calls them, the program itself included", () => {
  const made = update(work("CALL PGM DEF\nL X+63.4 Z+1.8 FMAX M303\nCYCL CALL", { "def.h": pgm(CYCLE) }));
  expect(
    made.run.operations.map(({ cycle, definedFile, definedIn, definedLine }) => [
      cycle,
      definedFile,
      definedIn,
      definedLine,
    ]),
  ).toEqual([[811, "def.h", 1, 2]]);
  expect(
    made.run.operations.map((o) => [isDefinedIn(o, null), isDefinedIn(o, "DEF.H"), isDefinedIn(o, "OTHER.H")]),
  ).toEqual([[false, true, false]]);
  expect(update(work("CALL PGM MAIN")).run.issues.map((f) => f.issue.code)).toContain("programsTooDeep");
});

test("skip marks are found in the program and in called files, and their blocks are skipped on request", () => {
  const files = { "CUT.H": pgm("/L Z+40 FMAX"), "OTHER.H": pgm("/L Z+30 FMAX") };
  const steps = (w: ProgramWork) => update(w).run.steps.length;
  expect(update(work("L Z+45 FMAX", files)).marked).toBe(false);
  expect(update(work("CALL PGM CUT", files)).marked).toBe(true);
  expect(update(work("/L Z+45 FMAX", files)).marked).toBe(true);
  const calls = "CALL PGM CUT\nL Z+52 FMAX";
  expect(steps(work(calls, files)) - steps(work(calls, files, true))).toBe(1);
});

test("a result belongs to a work while text, files and skip switch are the same", () => {
  const made = work("CALL PGM CUT", { "CUT.H": pgm("L Z+40 FMAX") });
  const outcome = { ...update(made), files: filesOf(made), skipMarked: false };
  expect(isMadeFrom(outcome, made)).toBe(true);
  expect(isMadeFrom(outcome, { ...made, name: "OTHER.H" })).toBe(true);
  expect(isMadeFrom(outcome, { ...made, text: "" })).toBe(false);
  expect(isMadeFrom(outcome, { ...made, files: [] })).toBe(false);
  expect(isMadeFrom(outcome, { ...made, skipMarked: true })).toBe(false);
});

test("a finding in a called program names its file in the list and in the verdict", () => {
  const outcome = update(work("CALL PGM CUT", { "cut.h": pgm("3 L X+Q77 FMAX\n4 CALL LBL 9") }));
  const entries = findingsOf(null, outcome);
  const missing = entries.find(({ issue }) => issue.code === "labelMissing");
  expect(missing).toMatchObject({ block: 7, inFile: { file: "cut.h", block: 4, line: 3 } });
  const verdict = shownVerdict(entries, outcome);
  expect(verdictTitle(words.verdict, "en", verdict)).toBe("2 errors, the first in cut.h");
  const own = shownVerdict(findingsOf(null, update(work("CALL LBL 9"))), outcome);
  expect(verdictTitle(words.verdict, "en", own)).toBe("1 error");
});

test("an unverified part of a called program is named with its file", () => {
  const outcome = update(work("CALL PGM CUT", { "cut.h": pgm("6 CYCL DEF 19.0 WORKING PLANE\n7 CYCL DEF 19.1 B+10") }));
  const verdict = shownVerdict(findingsOf(null, outcome), outcome);
  expect(verdictTitle(words.verdict, "en", verdict)).toBe("cut.h not fully simulated");
  expect(verdictReasons(words.verdict, verdict)[0]).toContain("in cut.h is not simulated");
  const own = update(work("6 CYCL DEF 19.0 WORKING PLANE\n7 CYCL DEF 19.1 B+10"));
  expect(verdictTitle(words.verdict, "en", shownVerdict(findingsOf(null, own), own))).toBe(words.verdict.unproved);
});

test("each text shows its own findings; the main program also those of called files, at the call", () => {
  const { run } = update(
    work("CALL PGM CUT\nCALL LBL 7", { "cut.h": pgm("4 CALL LBL 9"), "b.h": pgm("4 CALL LBL 9") }),
  );
  const errors = run.issues.filter((f) => f.issue.severity === "error");
  expect(findingsShown(errors, null).map(({ line }) => line)).toEqual([8, 9]);
  expect(findingsShown(errors, "CUT.H").map(({ block, line }) => [block, line])).toEqual([[4, 2]]);
  expect(findingsShown(errors, "b.h")).toEqual([]);
});
