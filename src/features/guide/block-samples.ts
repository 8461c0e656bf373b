import { cuttingCycles } from "../../cycles/index.ts";
import { never } from "../../kernel/never.ts";
import { exampleJob } from "../../program/job/job.ts";
import type { BlockKind } from "../../app/fields/blocks/block-kind.ts";
import { printedText } from "../../app/document/printed.ts";

/** The block that a sample is of begins with this. */
const MARK = "> ";

const CYLINDER = "BLK FORM CYLINDER Z D50 L60 DIST+1 DI20";
const program = (blank: readonly string[], lines: readonly string[]): readonly string[] => [
  "BEGIN PGM SAMPLE MM",
  ...blank,
  "TOOL CALL 1",
  "FUNCTION MODE TURN",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  "M136",
  "L X+58 Z+4 FMAX M3",
  ...lines,
  "L X+58",
  "L Z+4 FMAX",
  "M30",
  "END PGM SAMPLE MM",
];
const SOLID = "BLK FORM CYLINDER Z D50 L60 DIST+1";
/** One cut along the outside, with the block of the sample in it. */
const cut = (...lines: readonly string[]) => program([SOLID], lines);
/** The way to the cut, and the cut itself. */
const TO_CUT = ["L X+44 FMAX", "L Z-12 F0.25"];
const CONE = ["L X+42 Z+2 FMAX", "L X+46 Z-25 F0.25"];
const instead = (lines: readonly string[], line: string, ...others: readonly string[]) =>
  lines.flatMap((each) => (each === line ? others : [each]));

const PATHS: Partial<Record<BlockKind, readonly string[]>> = {
  L: cut("L X+42 Z+2 FMAX", "> L X+46 Z-25 F0.25"),
  CR: cut(...TO_CUT, "> CR X+50 Z-20 R10 DR+"),
  C: cut(...TO_CUT, "CC X+60 Z-12", "> C X+60 Z-20 DR-"),
  CT: cut(...TO_CUT, "> CT X+49 Z-22"),
  CC: cut(...TO_CUT, "> CC X+30 Z-12", "LP PR+10 PA+120"),
  LP: cut(...TO_CUT, "CC X+30 Z-12", "> LP PR+12 PA+125"),
  CP: cut(...TO_CUT, "CC X+60 Z-12", "> CP PA+220 DR-"),
  CTP: cut(...TO_CUT, "CC X+30 Z-12", "> CTP PR+14 PA+130"),
  RND: cut(...TO_CUT, "L Z-20", "> RND R3", "L X+58"),
  chamfer: cut(...TO_CUT, "L Z-20", "> CHF 2", "L X+58"),
};

const OTHERS: Partial<Record<BlockKind, readonly string[]>> = {
  begin: [`> BEGIN PGM SAMPLE MM`, ...cut(...CONE).slice(1)],
  end: [...cut(...CONE).slice(0, -1), "> END PGM SAMPLE MM"],
  blankCylinder: program([`> ${CYLINDER}`], CONE),
  blankRotation: [
    ...program(["> BLK FORM ROTATION Z DIM_D LBL 7"], CONE).slice(0, -1),
    "LBL 7",
    "L X+0 Z+1",
    "L X+50",
    "L Z-30",
    "L X+56",
    "L Z-60",
    "L X+0",
    "LBL 0",
    "END PGM SAMPLE MM",
  ],
  blankBox: program(["> BLK FORM 0.1 Z X-24 Y-24 Z-60", "BLK FORM 0.2 X+24 Y+24 Z+1"], CONE),
  toolCall: instead(cut(...CONE, "L Z-32"), "TOOL CALL 1", "> TOOL CALL 1 S1200"),
  toolDefinition: instead(cut(...CONE), "TOOL CALL 1", "> TOOL DEF 7 L+0 R+5", "TOOL CALL 1"),
  mode: instead(cut(...CONE), "FUNCTION MODE TURN", "> FUNCTION MODE TURN"),
  spin: cut("> FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500", "L X+40 Z+1 FMAX", "L X+2 F0.2", "L Z+3 FMAX"),
  turnCorrection: cut("> FUNCTION TURNDATA CORR-TCS:Z/X DZL:0 DXL:0", ...CONE),
  turnBlank: cut("> FUNCTION TURNDATA BLANK OFF", ...CONE),
  functions: instead(cut(...CONE), "M136", "> M136"),
  label: cut("> LBL 1", ...CONE, "L X+58", "LBL 0"),
  call: cut(
    "L X+50 Z+2 FMAX",
    "LBL 1",
    "L IX-3 FMAX",
    "L Z-20 F0.25",
    "L IX+2",
    "L Z+2 FMAX",
    "L IX-2",
    "> CALL LBL 1 REP3",
  ),
  assign: cut("> FN 0: Q1 =+42", "L X+Q1 Z+2 FMAX", "L Z-25 F0.25"),
  stop: cut(...CONE, "> STOP"),
  datum: cut("> TRANS DATUM AXIS X+0 Z-10", ...CONE),
  rotation: cut("> TRANS ROTATION ROT+30"),
  scale: cut("> TRANS SCALE SCL0.99"),
  structure: cut("> * - OUTSIDE", ...CONE),
  comment: cut("> ; OUTSIDE", ...CONE),
  selectContour: cut(`> SEL CONTOUR "CONTOUR.H"`),
  cycleCall: cut("> CYCL CALL"),
  free: cut(...TO_CUT, "> FL AN+30"),
};

/** Words that are shown in another sample than their block. */
const OF_WORD: Readonly<Record<string, readonly string[]>> = {
  "L.compensation": cut("L X+42 Z+2 R0 FMAX", "> L X+46 Z-25 R0 F0.25"),
  "spin.constantSurface": cut(
    "> FUNCTION TURNDATA SPIN VCONST:ON VC:180 S790 SMAX2500",
    "L X+40 Z+1 FMAX",
    "L X+2 F0.2",
    "L Z+3 FMAX",
  ),
  "spin.speed": cut("> FUNCTION TURNDATA SPIN VCONST:OFF S790", ...CONE),
  "RND.feed": cut(...TO_CUT, "L Z-20", "> RND R6 F0.1", "L X+58"),
  "chamfer.feed": cut(...TO_CUT, "L Z-20", "> CHF 4 F0.1", "L X+58"),
  "CR.feed": cut(...TO_CUT, "> CR X+50 Z-20 R10 DR+ F0.2"),
  "CT.feed": cut(...TO_CUT, "> CT X+49 Z-22 F0.2"),
  "C.feed": cut(...TO_CUT, "CC X+60 Z-12", "> C X+60 Z-20 DR- F0.2"),
  "LP.feed": cut(...TO_CUT, "CC X+30 Z-12", "> LP PR+12 PA+125 F0.2"),
  "CP.feed": cut(...TO_CUT, "CC X+60 Z-12", "> CP PA+220 DR- F0.2"),
  "CTP.feed": cut(...TO_CUT, "CC X+30 Z-12", "> CTP PR+14 PA+130 F0.2"),
};

/** A slender insert, so that undercuts and recesses are seen as they are written. */
const SLENDER = "TOOL CALL 4";

/** An element of a contour that a cycle cuts: an undercut or a recess. */
function inContour(element: string): readonly string[] {
  const cycle = cuttingCycles.find(({ contour }) => contour === "free") ?? never("no cycle of a free contour");
  const lines = printedText(exampleJob(cycle))
    .split(/\r?\n/)
    .map((line) => line.replace(/^\d+\s+/, ""))
    .filter((line) => line !== "");
  const from = lines.findLastIndex((line) => /^LBL [^0]/.test(line)),
    to = lines.findIndex((line, i) => i > from && /^LBL 0/.test(line));
  return lines
    .toSpliced(from + 1, to - from - 1, "L X+20 Z+0", "L Z-30", element, "L X+44", "L Z-45")
    .map((line) => line.replace(/^TOOL CALL \d+/, SLENDER));
}

const UNDERCUT = "> UDC TYPE_F R0.8 DEPTH0.5 BREADTH4 ANGLE15 FACEDEPTH0.4 FACEANGLE8";
const GROOVE = "> GRV RADIAL CENTER-15";
/** Elements of a contour, and words of theirs that do not go with the others. */
const ELEMENTS: Readonly<Record<string, string>> = {
  undercut: UNDERCUT,
  "undercut.form": "> UDC TYPE_E R0.8",
  groove: `${GROOVE} R0.4 DEPTH-2 BREADTH8 ANGLE45 CHF0.5`,
  "groove.DIAM": `${GROOVE} DIAM+16 BREADTH8 ANGLE45`,
  "groove.ANG_WIDTH": `${GROOVE} DEPTH-2 BREADTH8 ANG_WIDTH60`,
  "groove.RND": `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 RND0.5`,
  "groove.FAR_RND": `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 RND0.2 FAR_RND0.8`,
  "groove.FAR_CHF": `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 CHF0.2 FAR_CHF0.8`,
};

/** A small program in which a block acts, with one of its words; null where there is none of this kind. */
export interface BlockSample {
  readonly text: string;
  /** Its line, from 1. */
  readonly line: number;
}

export function blockSample(kind: BlockKind, word: string | null): BlockSample | null {
  const element = (word === null ? undefined : ELEMENTS[`${kind}.${word}`]) ?? ELEMENTS[kind];
  const lines =
    (word === null ? undefined : OF_WORD[`${kind}.${word}`]) ??
    PATHS[kind] ??
    OTHERS[kind] ??
    (element && inContour(element));
  if (!lines) return null;
  return {
    text: `${lines.map((line) => line.replace(MARK, "")).join("\n")}\n`,
    line: lines.findIndex((line) => line.startsWith(MARK)) + 1,
  };
}
