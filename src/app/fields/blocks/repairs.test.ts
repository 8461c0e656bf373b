import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { engine } from "../../calculation/engine.ts";
import type { Outcome } from "../../calculation/outcome.ts";
import { findingsOf } from "../../findings/findings.ts";
import { texts } from "../../../i18n/index.ts";
import { issueText } from "../../calculation/issue-text.ts";
import { lengthsOf } from "../../calculation/lengths.ts";
import { parse } from "../../../nc/parse.ts";
import { print } from "../../../nc/program.ts";
import { NC_OUTPUTS } from "../../../program/machine/nc-output.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { repairsOf, withTool } from "./repairs.ts";

const outcomeOf = (text: string): Outcome =>
  engine.update({
    version: 1,
    text,
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  });

const cycle812 = (q = "") =>
  `CYCL DEF 812 SHOULDER, LONG. EXT. ~
Q215=+0 ;MACHINING OPERATION ~
Q460=+2.1 ;SAFETY CLEARANCE ~
Q491=+61.3 ;DIAMETER AT CONTOUR START ~
Q492=+0 ;CONTOUR START IN Z ~
Q493=+47.7 ;DIAMETER AT CONTOUR END ~
Q494=-31.9 ;CONTOUR END IN Z ~
Q495=+0 ;ANGLE OF CIRCUM. SURFACE ~
Q501=+0 ;TYPE OF STARTING ELEMENT ~
Q502=+0 ;SIZE OF STARTING ELEMENT ~
Q500=+1.1 ;RADIUS OF CONTOUR EDGE ~
Q496=+0 ;ANGLE OF FACE ~
Q503=+0 ;TYPE OF END ELEMENT ~
Q504=+0 ;SIZE OF END ELEMENT ~
Q463=+2.3 ;MAX. CUTTING DEPTH ~
Q478=+0.27 ;ROUGHING FEED RATE ~
Q483=+0.4 ;OVERSIZE FOR DIAMETER ~
Q484=+0.2 ;OVERSIZE IN Z ~
Q505=+0.19 ;FINISHING FEED RATE ~
Q506=+0 ;CONTOUR SMOOTHING${q}`;

/** The blocks of a correct program, one a line. */
const RIGHT = [
  "BEGIN PGM A MM",
  "BLK FORM CYLINDER Z D61.3 L80 DIST+0",
  "FUNCTION MODE TURN",
  "TOOL CALL 1",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  "M136",
  "L X+90 Z+40 R0 FMAX",
  cycle812(),
  "L X+61.3 Y+0 Z+2 FMAX M303",
  "CYCL CALL",
  "L Z+40 FMAX",
  "M30",
  "END PGM A MM",
];
const numbered = (blocks: readonly string[]) => `${blocks.map((block, i) => `${i} ${block}`).join("\n")}\n`;
const without = (...gone: string[]) => numbered(RIGHT.filter((block) => !gone.includes(block)));
const changed = (before: string, after: string) => numbered(RIGHT.map((block) => (block === before ? after : block)));

/** A cycle that takes its contour from a subprogram. */
const FREE = `CYCL DEF 810 TURN CONTOUR LONG. ~
Q215=+0 ~
Q460=+2 ~
Q499=+0 ~
Q463=+2.3 ~
Q478=+0.27 ~
Q483=+0.4 ~
Q484=+0.2 ~
Q505=+0.19 ~
Q487=+1 ~
Q488=+0 ~
Q479=+0 ~
Q480=+0 ~
Q482=+0 ~
Q506=+0`;

/** A subprogram that nothing calls. */
const UNUSED = "L Z+40 FMAX\nLBL 3\nL X+100 FMAX\nLBL 0";

/** A contour with a rounding that is too large for its neighbours, as the cycle names it. */
const NAMED = "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL3";
const withContour = (corner: string, free = FREE) =>
  numbered([
    ...RIGHT.flatMap((block) => (block === cycle812() ? [...NAMED.split("\n"), free] : [block])).slice(0, -1),
    "LBL 3",
    "L X+37.4 Z+0",
    "L Z-20",
    corner,
    "L X+61.3",
    "L Z-40",
    "LBL 0",
    "END PGM A MM",
  ]);

/** A thread with a constant cutting speed. */
const THREAD = readFileSync("tests/programs/cycle-831.h", "utf8").replace(
  "VCONST:OFF S640",
  "VCONST:ON VC:120 SMAX3000",
);

/** Finding, program, and the block, word or value that is offered first. */
const cases: readonly (readonly [code: string, text: string, offered: string | number])[] = [
  [
    "spindleStopped",
    without("FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500"),
    "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  ],
  ["spindleStopped", changed("L X+61.3 Y+0 Z+2 FMAX M303", "L X+61.3 Y+0 Z+2 FMAX M5"), "M303"],
  ["spindleStopped", changed("L X+61.3 Y+0 Z+2 FMAX M303", "L X+61.3 Y+0 Z+2 FMAX M8"), "M303"],
  ["programEndMissing", without("M30", "END PGM A MM"), "M30"],
  ["blankMissing", without("BLK FORM CYLINDER Z D61.3 L80 DIST+0"), "BLK FORM CYLINDER Z D80 L100 DIST+1"],
  ["notInTurnMode", changed("FUNCTION MODE TURN", "FUNCTION MODE MILL"), "FUNCTION MODE TURN"],
  ["cycleNeverCalled", without("CYCL CALL"), "CYCL CALL"],
  ["noToolCalled", without("TOOL CALL 1"), "TOOL CALL 1"],
  ["startUnknown", without("L X+90 Z+40 R0 FMAX", "L X+61.3 Y+0 Z+2 FMAX M303"), "L X+61.3 Z+2 FMAX M303"],
  ["contourNotNamed", changed(cycle812(), FREE), "CYCL DEF 14, LBL 1"],
  ["labelMissing", changed(cycle812(), `CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL7\n${FREE}`), "LBL 7"],
  ["feedUnlikely", without("M136"), "M136"],
  ["feedUnlikely", changed("M136", "M137"), "M136"],
  ["feedUnlikely", changed("M136", "L X+100 FMAX M137"), "M136"],
  ["labelMissing", changed("L Z+40 FMAX", `CALL LBL 5\n${UNUSED}`), "LBL 3"],
  ["labelMissing", changed("L Z+40 FMAX", `FN 9: IF +1 EQU +1 GOTO LBL 5\n${UNUSED}`), "LBL 3"],
  ["labelMissing", changed("L Z+40 FMAX", `CALL LBL "HOMME"\n${UNUSED.replace("3", '"HOME"')}`), 'LBL "HOME"'],
  ["labelMissing", changed(cycle812(), `CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL5\n${FREE}\n${UNUSED}`), "LBL 3"],
  ["parameterForeign", changed(cycle812(), cycle812(" ~\nQ999=+3 ;STRANGE")), "Q999"],
  ["compensationActive", changed("L X+61.3 Y+0 Z+2 FMAX M303", "L X+61.3 Y+0 Z+2 RR FMAX M303"), "R0"],
  ["frameMissing", without("END PGM A MM"), "END PGM A MM"],
  ["frameMissing", without("BEGIN PGM A MM"), "BEGIN PGM A MM"],
  ["missing", withContour("RND R1", FREE.replace("Q499=+0 ~\n", "")), "Q499 = 0"],
  ["cornerElementTooLong", withContour("RND R25"), "RND R11.95"],
  ["cornerElementTooLong", withContour("CHF 25"), "CHF 11.95"],
  ["threadSurfaceSpeed", THREAD, "VCONST:OFF S1157"],
  [
    "endInFront",
    changed(cycle812(), cycle812().replace("Q494=-31.9", "Q494=+31.9")).replace("TOOL CALL 1", "TOOL CALL 42"),
    -31.9,
  ],
  ["outOfRange", changed(cycle812(), cycle812().replace("Q463=+2.3", "Q463=+1200")), 5],
];

const codes = (text: string) => findingsOf(null, outcomeOf(text)).map(({ issue }) => issue.code as string);

test("the program on which the cases are based is correct", () => {
  expect(findingsOf(null, outcomeOf(numbered(RIGHT))).filter(({ issue }) => issue.severity === "error")).toEqual([]);
});

test.each(cases)("%s is fixed by the offered repair", (code, text, offered) => {
  const entry = findingsOf(null, outcomeOf(text)).find(({ issue }) => issue.code === code);
  if (!entry) throw new Error(`not found: ${code}; found: ${codes(text).join(" ")}`);
  const repairs = repairsOf(parse(text), entry, "en", NC_OUTPUTS.manual);
  expect(repairs[0]?.text).toBe(offered);
  for (const { next } of repairs) expect(codes(print(next()))).not.toContain(code);
});

test("setting a value changes nothing else", () => {
  const text = changed(cycle812(), cycle812().replace("Q463=+2.3", "Q463=+1200"));
  const entry = findingsOf(null, outcomeOf(text)).find(({ issue }) => issue.code === "outOfRange");
  const [repair] = entry ? repairsOf(parse(text), entry, "en", NC_OUTPUTS.manual) : [];
  expect(repair && print(repair.next())).toBe(text.replace("Q463=+1200", "Q463=+5"));
});

test("another tool replaces the tool of the previous call", () => {
  const text = numbered(RIGHT);
  expect(print(withTool(parse(text), 9, 4))).toBe(text.replace("TOOL CALL 1", "TOOL CALL 4"));
});

test("M303 is added to the positioning block, which keeps its functions; if that is full or stops, M303 gets a new block", () => {
  const mended = (position: string) => {
    const text = changed("L X+61.3 Y+0 Z+2 FMAX M303", position);
    const entry = findingsOf(null, outcomeOf(text)).find(({ issue }) => issue.code === "spindleStopped");
    return (entry ? repairsOf(parse(text), entry, "en", NC_OUTPUTS.manual) : []).map((repair) => print(repair.next()));
  };
  const around = (...blocks: string[]) => [
    numbered(RIGHT.flatMap((block) => (block === "L X+61.3 Y+0 Z+2 FMAX M303" ? blocks : [block]))),
  ];
  expect(mended("L X+61.3 Y+0 Z+2 FMAX M8")).toEqual(around("L X+61.3 Y+0 Z+2 FMAX M8 M303"));
  expect(mended("L X+61.3 Y+0 Z+2 FMAX M5")).toEqual(around("L X+61.3 Y+0 Z+2 FMAX M5", "M303"));
  expect(mended("L X+61.3 Y+0 Z+2 FMAX M8 M5")).toEqual(around("L X+61.3 Y+0 Z+2 FMAX M8 M5", "M303"));
});

test("in an inch program a value is offered and shown in inches: the infeed limit of a tool is not a foot", () => {
  const text = readFileSync("tests/programs/shoulder-inch.h", "utf8").replace("Q463=+0.1181", "Q463=+0.9");
  const outcome = outcomeOf(text),
    entry = findingsOf(null, outcome).find(({ issue }) => issue.code === "infeedOverCutLength");
  if (!entry) throw new Error("it is found");
  const [repair] = repairsOf(parse(text), entry, "en", NC_OUTPUTS.manual);
  expect(repair?.text).toBe(0.4724);
  expect(repair && print(repair.next())).toContain("Q463=+0.4724 ");
  const said = issueText(texts("en"), lengthsOf("en", outcome.run.program.unit), entry.issue, 812);
  expect(said).toBe("Infeed 0.9 exceeds CUTLENGTH 0.4724: reduced to 0.4724.");
  const mend = (body: string) => repairsOf(parse(body), { ...entry, at: "Q463" }, "en", NC_OUTPUTS.manual)[0];
  expect(mend(text.replace(" INCH\n1", " MM\n1"))?.text).toBe(12);
});

test("swapped ends are swapped back in one step", () => {
  const before = changed(
    cycle812(),
    cycle812()
      .replace("Q491=+61.3", "Q491=+47.7")
      .replace("Q493=+47.7 ;DIAMETER AT CONTOUR END", "Q493=+61.3 ;DIAMETER AT CONTOUR END"),
  );
  const program = parse(before),
    [entry] = findingsOf(null, outcomeOf(before));
  expect(entry?.issue.code).toBe("endsExchanged");
  const [repair] = entry ? repairsOf(program, entry, "en", NC_OUTPUTS.manual) : [];
  const text = repair ? print(repair.next()) : "";
  expect(text).toBe(numbered(RIGHT));
});
