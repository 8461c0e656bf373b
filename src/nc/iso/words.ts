import type { AxisName, Compensation, FunctionNumber, PathKind } from "../words.ts";

/**
 * Evidence for a word: A printed for TNC 640 or TNC7, B for a sibling control, K1 to K3 recalled, from sure to
 * uncertain.
 */
export type IsoEvidence = "A" | "B" | "K1" | "K2" | "K3";

/** Path functions with a G word; with a radius in the block, C becomes CR. */
export type IsoPath = Extract<PathKind, "L" | "C" | "CT" | "LP" | "CP" | "CTP">;
/** Blocks with their own word that are not part of a path. */
export type IsoBlockName =
  | "pole"
  | "polePosition"
  | "chamfer"
  | "rounding"
  | "stop"
  | "cycleCall"
  | "label"
  | "call"
  | "toolCall"
  | "toolDefinition"
  | "blankMinimum"
  | "blankMaximum"
  | "callProgram"
  | "raise"
  | "cycle"
  | "parameters"
  | "radiusArc"
  | "mixed"
  | "begin"
  | "end";

/** The meaning of a word. */
export type IsoMeaning =
  | { readonly kind: "path"; readonly path: IsoPath; readonly rapid?: true; readonly turn?: "cw" | "ccw" | "last" }
  | { readonly kind: "compensation"; readonly value: Compensation }
  /** Tool axis, and with it the working plane. */
  | { readonly kind: "plane"; readonly axis: AxisName }
  | { readonly kind: "dimension"; readonly incremental: boolean }
  | { readonly kind: "unit"; readonly unit: "MM" | "INCH" }
  | { readonly kind: "function"; readonly fn: FunctionNumber }
  | { readonly kind: "jump"; readonly fn: 9 | 10 | 11 | 12 }
  /** A cycle of numbered lines; `row`: a row of the datum table instead of a shift. */
  | { readonly kind: "olderCycle"; readonly cycle: number; readonly row?: true }
  /** A cycle with Q parameters whose G number is not its own number. */
  | { readonly kind: "shiftedCycle"; readonly cycle: number }
  | { readonly kind: "block"; readonly block: IsoBlockName }
  /** A word of the control that is not translated: its block is kept and reported. */
  | { readonly kind: "unread" };

/** One row of the table: a word, its meaning, a Klartext example and the source. */
export interface IsoWord {
  readonly word: string;
  readonly means: IsoMeaning;
  /** Klartext example; several lines for a cycle with numbered lines. Empty for a word that is only read. */
  readonly klartext: string;
  readonly evidence: IsoEvidence;
  /** Key of `isoSources`; empty for what is recalled. */
  readonly source: keyof typeof isoSources | "";
}

/** Printed pages with DIN/ISO words. */
export const isoSources = {
  CYCL: "TNC 640 cycle manual 10/2019 and TNC7: each turning cycle is named with its G number",
  T640: "TNC 640 34059x-05 ISO 1/2015, p. 171 and 234",
  T320: "TNC 320 ISO 10/2017, p. 128",
  I530: "iTNC 530 340 49x-04 ISO, p. 230",
  I616: "iTNC 530 ISO 6/2010, p. 616",
  T426: "TNC 426 280 476 Pilot, ISO page of G functions",
  T430: "TNC 410/426/430 ISO, p. 283",
  T407: "TNC 407 280 580 ISO, p. 5-17 and 5-25",
  T360: "TNC 360 ISO, sheet of G functions, p. 5-9 and 7-5",
} as const;

const path = (
  at: IsoPath,
  more: { readonly rapid?: true; readonly turn?: "cw" | "ccw" | "last" } = {},
): IsoMeaning => ({
  kind: "path",
  path: at,
  ...more,
});
const block = (name: IsoBlockName): IsoMeaning => ({ kind: "block", block: name });
const older = (cycle: number): IsoMeaning => ({ kind: "olderCycle", cycle });
const shifted = (cycle: number): IsoMeaning => ({ kind: "shiftedCycle", cycle });
const fn = (n: FunctionNumber): IsoMeaning => ({ kind: "function", fn: n });
const jump = (n: 9 | 10 | 11 | 12): IsoMeaning => ({ kind: "jump", fn: n });
const unread: IsoMeaning = { kind: "unread" };

type Row = readonly [
  word: string,
  means: IsoMeaning,
  klartext: string,
  evidence: IsoEvidence,
  source?: keyof typeof isoSources,
];

const ROWS: readonly Row[] = [
  ["%", block("begin"), "BEGIN PGM PART MM", "B", "T320"],
  ["N99999999", block("end"), "END PGM PART MM", "B", "T320"],
  ["G71", { kind: "unit", unit: "MM" }, "BEGIN PGM PART MM", "B", "T426"],
  ["G70", { kind: "unit", unit: "INCH" }, "BEGIN PGM PART INCH", "B", "T426"],
  ["G30", block("blankMinimum"), "BLK FORM 0.1 Z X+0 Y+0 Z-40", "B", "T407"],
  ["G31", block("blankMaximum"), "BLK FORM 0.2 X+100 Y+100 Z+0", "B", "T407"],
  ["T", block("toolCall"), "TOOL CALL 5 Z S3000 F200 DL+0.1 DR-0.05", "B", "T407"],
  ["G17", { kind: "plane", axis: "Z" }, "TOOL CALL 5 Z S3000", "B", "T426"],
  ["G18", { kind: "plane", axis: "Y" }, "TOOL CALL 5 Y S3000", "B", "T426"],
  ["G19", { kind: "plane", axis: "X" }, "TOOL CALL 5 X S3000", "B", "T426"],
  ["G99", block("toolDefinition"), "TOOL DEF 5 L+10 R+5", "A", "T640"],
  ["G00", path("L", { rapid: true }), "L X+70 Z+3 R0 FMAX", "B", "I530"],
  ["G01", path("L"), "L X+60 Z-5 F0.2 M8", "A", "T640"],
  ["G10", path("LP", { rapid: true }), "LP PR+30 PA+0 FMAX", "B", "T360"],
  ["G11", path("LP"), "LP PR+30 IPA+60", "A", "T640"],
  ["I J K", block("pole"), "CC X+40 Z-5", "A", "T640"],
  ["G29", block("polePosition"), "CC", "B", "T426"],
  ["G02", path("C", { turn: "cw" }), "C X+60 Z-5 DR-", "B", "I530"],
  ["G03", path("C", { turn: "ccw" }), "C X+60 Z-5 DR+", "B", "I530"],
  ["R", block("radiusArc"), "CR X+60 Z-5 R+8 DR+", "B", "I530"],
  ["G05", path("C", { turn: "last" }), "", "B", "I530"],
  ["G06", path("CT"), "CT X+60 Z-5", "B", "T407"],
  ["G12", path("CP", { turn: "cw" }), "CP PA+40 DR-", "A", "T640"],
  ["G13", path("CP", { turn: "ccw" }), "CP IZ-5 IPA+720 DR+", "A", "T640"],
  ["G15", path("CP", { turn: "last" }), "", "A", "T640"],
  ["G16", path("CTP"), "CTP PR+30 PA+30", "A", "T640"],
  ["G24", block("chamfer"), "CHF 2", "B", "T426"],
  ["G25", block("rounding"), "RND R1.5 F0.1", "B", "T426"],
  ["G40", { kind: "compensation", value: "R0" }, "L X+80 R0", "B", "T426"],
  ["G41", { kind: "compensation", value: "RL" }, "L X+60 RL", "B", "T426"],
  ["G42", { kind: "compensation", value: "RR" }, "L X+60 RR", "A", "T640"],
  ["G90", { kind: "dimension", incremental: false }, "L X+60 Z-5", "B", "T426"],
  ["G91", { kind: "dimension", incremental: true }, "L IX-2 IZ-5", "B", "T426"],
  ["G90 … G91 …", block("mixed"), "L X+60 IZ-5", "K1"],
  ["G98", block("label"), "LBL 2", "B", "I616"],
  ["L", block("call"), "CALL LBL 2 REP 5", "K1"],
  ["%", block("callProgram"), "CALL PGM DRILL.H", "K2"],
  ["G38", block("stop"), "STOP M6", "B", "T426"],
  ["G79", block("cycleCall"), "CYCL CALL M3", "K1"],
  ["G…", block("cycle"), "CYCL DEF 200 DRILLING ~\nQ200=+2 ~\nQ201=-20", "A", "CYCL"],
  ["Q…=…", block("parameters"), "CYCL DEF 221 CARTESIAN PATTERN ~\nQ225=+15 ~\nQ226=+15", "B", "T430"],
  ["G120", shifted(20), "CYCL DEF 20 CONTOUR DATA ~\nQ1=-20", "K1"],
  ["G121", shifted(21), "CYCL DEF 21 PILOT DRILLING ~\nQ10=-5", "K1"],
  ["G122", shifted(22), "CYCL DEF 22 ROUGH-OUT ~\nQ10=-5", "K1"],
  ["G123", shifted(23), "CYCL DEF 23 FLOOR FINISHING ~\nQ11=+100", "K1"],
  ["G124", shifted(24), "CYCL DEF 24 SIDE FINISHING ~\nQ9=+1", "K1"],
  ["G125", shifted(25), "CYCL DEF 25 CONTOUR TRAIN ~\nQ1=-20", "K1"],
  ["G127", shifted(27), "CYCL DEF 27 CYLINDER SURFACE ~\nQ1=-8", "K1"],
  ["G128", shifted(28), "CYCL DEF 28 CYLINDER SURFACE ~\nQ1=-8", "K1"],
  ["G129", shifted(29), "CYCL DEF 29 CYL SURFACE RIDGE ~\nQ1=-8", "K2"],
  ["G139", shifted(39), "CYCL DEF 39 CYL. SURFACE CONTOUR ~\nQ1=-8", "K2"],
  ["G37", older(14), "CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL2 /5", "B", "I616"],
  ["G54", older(7), "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+1.3\nCYCL DEF 7.2 IZ-20", "B", "T360"],
  ["G53", { kind: "olderCycle", cycle: 7, row: true }, "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #5", "K1"],
  ["G28", older(8), "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X Y", "B", "T360"],
  ["G04", older(9), "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 0.5", "B", "T360"],
  ["G73", older(10), "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30", "B", "T360"],
  ["G72", older(11), "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.99", "B", "T360"],
  ["G39", older(12), "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM DRILL.H", "K3"],
  ["G36", older(13), "CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE 90", "B", "T360"],
  ["G80", older(19), "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+45", "K2"],
  ["G62", older(32), "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05", "K2"],
  ["D00", fn(0), "FN 0: Q5 = +60", "B", "T360"],
  ["D01", fn(1), "FN 1: Q1 = -Q2 + -5", "B", "T360"],
  ["D02", fn(2), "FN 2: Q1 = +10 - +5", "B", "T360"],
  ["D03", fn(3), "FN 3: Q2 = +3 * +3", "B", "T360"],
  ["D04", fn(4), "FN 4: Q4 = +8 DIV +Q2", "B", "T360"],
  ["D05", fn(5), "FN 5: Q20 = SQRT +4", "B", "T360"],
  ["D06", fn(6), "FN 6: Q20 = SIN -Q5", "K1"],
  ["D07", fn(7), "FN 7: Q21 = COS -Q5", "K1"],
  ["D08", fn(8), "FN 8: Q10 = +5 LEN +4", "K1"],
  ["D09", jump(9), "FN 9: IF +Q1 EQU +Q3 GOTO LBL 10", "K1"],
  ["D10", jump(10), "FN 10: IF +10 NE -Q5 GOTO LBL 10", "K1"],
  ["D11", jump(11), 'FN 11: IF +Q1 GT +10 GOTO LBL "END"', "K1"],
  ["D12", jump(12), "FN 12: IF +Q5 LT +0 GOTO LBL 1", "K1"],
  ["D13", fn(13), "FN 13: Q20 = +10 ANG -Q1", "K1"],
  ["D14", block("raise"), "FN 14: ERROR=1000", "K2"],
  ["G07", unread, "", "B", "T360"],
  ["G20", unread, "", "B", "T426"],
  ["G26", unread, "", "B", "T426"],
  ["G27", unread, "", "B", "T426"],
  ["G43", unread, "", "B", "T426"],
  ["G44", unread, "", "B", "T426"],
  ["G51", unread, "", "B", "T426"],
];

/** The table that printer, reader and `docs/din-iso.md` share. A word that is only read has no Klartext example. */
export const isoWords: readonly IsoWord[] = ROWS.map(([word, means, klartext, evidence, source]): IsoWord => ({
  word,
  means,
  klartext,
  evidence,
  source: source ?? "",
}));

/** True for a word without a printed source. */
export const isRecalledIsoWord = ({ evidence }: Pick<IsoWord, "evidence">): boolean => evidence.startsWith("K");

const keyOf = (means: IsoMeaning): string => JSON.stringify(means, Object.keys(means).sort());
const byMeaning: ReadonlyMap<string, string> = new Map(isoWords.map(({ word, means }) => [keyOf(means), word]));
const byCode: ReadonlyMap<string, IsoMeaning> = new Map(
  isoWords.flatMap(({ word, means }) => {
    const m = /^([GD])(\d+)$/.exec(word);
    return m ? [[`${m[1]}${Number(m[2])}`, means] as const] : [];
  }),
);

/** The word for a meaning; null where DIN/ISO has none. */
export const isoWordFor = (means: IsoMeaning): string | null => byMeaning.get(keyOf(means)) ?? null;

/** The meaning of a G or D function; null where it is not in the table. */
export const isoMeaningOf = (letter: "G" | "D", code: number): IsoMeaning | null =>
  byCode.get(`${letter}${code}`) ?? null;

/** First G number that is a cycle number with Q parameters. */
export const FIRST_CYCLE = 200;
