import fc from "fast-check";

/*
 * Programs in which one block acts on others: label calls with and without repetition, jumps, Q parameters, datum
 * shifts, several tools, compensated contours and contours behind labels.
 */

const tool = (T: number, ...functions: readonly string[]): string[] => [
  `TOOL CALL ${T}`,
  "FUNCTION TURNDATA SPIN VCONST:ON VC:140 SMAX2500",
  `L X+120 Z+60 R0 FMAX M303 ${functions.join(" ")}`.trimEnd(),
];
const shoulder = (end: number): string[] => [
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~\n" +
    `Q215=+1 ~\nQ460=+2 ~\nQ493=+Q2 ~\nQ494=-${end} ~\nQ463=+4.5 ~\nQ478=+0.3 ~\nQ483=+0.4 ~\nQ484=+0.1 ~\n` +
    "Q505=+0.2 ~\nQ506=+0",
  "L X+Q3 Z+2 FMAX",
];
const along = (label: number): string[] => [
  `CYCL DEF 14.0 CONTOUR GEOMETRY`,
  `CYCL DEF 14.1 CONTOUR LABEL${label}`,
  "CYCL DEF 810 TURN CONTOUR LONG. ~\n" +
    "Q215=+1 ~\nQ460=+2 ~\nQ499=+0 ~\nQ463=+5 ~\nQ478=+0.3 ~\nQ483=+0.5 ~\nQ484=+0.2 ~\nQ505=+0.12 ~\nQ487=+1 ~\n" +
    "Q488=+0.15 ~\nQ479=+0 ~\nQ480=+0 ~\nQ482=+0 ~\nQ506=+0",
  "L X+82 Z+2 FMAX",
  "CYCL CALL",
];

/** The effects that a part of a program may have; `label` is its own label. */
const PARTS: Readonly<Record<string, (label: number, n: number) => readonly string[]>> = {
  cycle: (_, n) => [...shoulder(9 + n), "CYCL CALL"],
  calledTwice: (_, n) => [...shoulder(12 + n), "L Z+3 FMAX M99", `Q2 = Q2 - ${n}`, "L Z+2 FMAX M99"],
  contour: () => along(91),
  repeated: (label, n) => [
    `LBL ${label}`,
    `Q2 = Q2 - ${n / 2}`,
    "L X+Q2 FMAX",
    "L Z-8 F0.2",
    "L IX+2 F0.2",
    "L Z+2 FMAX",
    `CALL LBL ${label} REP2`,
  ],
  repeatedCycle: (label, n) => [
    `LBL ${label}`,
    ...shoulder(6 + n),
    "CYCL CALL",
    "Q2 = Q2 - 3",
    `CALL LBL ${label} REP2`,
    "L X+90 Z+3 FMAX",
    `L X+76 FMAX`,
    "L Z-2 F0.2",
  ],
  free: (_, n) => ["L X+60 Z+3 FMAX", "L Z+1 F0.2", `FL X+64 Z-${n}`, "FLT X+70 Z-9", "FL X+84 Z-9", "L X+90 FMAX"],
  // The end of the first element follows from the second element.
  freeTogether: (_, n) => ["L X+60 Z+3 FMAX", "L Z+1 F0.2", "FL AN180", `FL X+76 Z-${8 + n} AN135`, "L X+90 FMAX"],
  looped: (label) => [
    "Q1 = +3",
    `LBL ${label}`,
    "L Z-4 F0.15",
    "L Z+2 FMAX",
    "Q1 = Q1 - 1",
    `FN 11: IF +Q1 GT +0 GOTO LBL ${label}`,
  ],
  subprogram: (_, n) => [`Q4 = +${n}`, "CALL LBL 90", `Q4 = +${n + 3}`, "CALL LBL 90"],
  jumped: (label, n) => [
    `FN 9: IF +Q4 EQU +${n} GOTO LBL ${label}`,
    "L X+76 FMAX",
    "; INTENDED CUT",
    "L Z-3 F0.1",
    "L X+90 FMAX",
    "CALL LBL 93 REP6",
    `LBL ${label}`,
    "L Z+2 FMAX",
  ],
  guessed: (label) => [`FN 9: IF +Q77 EQU +1 GOTO LBL ${label}`, "L Z+4 FMAX", `LBL ${label}`],
  set: (_, n) => [`Q77 = +${n} * Q4`, "Q2 = Q2 - 0.5", 'QS5 = "TEXT"'],
  shifted: (_, n) => ["CYCL DEF 7.0 DATUM SHIFT", `CYCL DEF 7.1 Z-${n}`],
  shiftedBack: () => ["TRANS DATUM RESET"],
  otherTool: () => ["L X+140 Z+80 FMAX", ...tool(3, "M136")],
  blade: (_, n) => ["L X+140 Z+80 FMAX", ...tool(9), `L X+84 Z-${20 + n} FMAX`, "L X+70 F0.08", "L X+84 F0.5"],
  compensated: () => ["L X+60 Z+4 FMAX", "L X+70 Z-2 RR F0.2", "L Z-9", "RND R1", "L X+84", "L Z+4 R0 FMAX"],
  // Without its other values nothing is cut.
  recalled: () => ["CYCL DEF 812 SHOULDER, LONG. EXT. ~\nQ215=+1", "CYCL CALL"],
  called: (_, n) => [`Q2 = Q2 - ${n}`, "CALL PGM SUB"],
  marked: (_, n) => [`/L X+${70 + n} Z+1 FMAX`, "/L Z-3 F0.2", "L X+84 FMAX"],
  noted: () => ["; a note", "* - STRUCTURE"],
  traced: () => ["FUNCTION TURNDATA BLANK LBL 92"],
};

const HEAD = ["BEGIN PGM LAW MM", "BLK FORM CYLINDER Z D80 L90 DIST+1", "FUNCTION MODE TURN", "Q2 = +70", "Q3 = +82"];
const TAIL = [
  "L X+150 Z+90 FMAX M30",
  "LBL 90",
  "L X+81 Z+1 FMAX",
  "L X+Q2 Z-Q4 F0.2",
  "L X+82 FMAX",
  "LBL 0",
  "LBL 93",
  "L IX+1 FMAX",
  "LBL 0",
  "LBL 91",
  "L X+50 Z+0",
  "L Z-10",
  "L X+Q2 Z-18",
  "L X+82",
  "LBL 0",
  "LBL 92",
  "L X+0 Z+1",
  "L X+79",
  "L Z-89",
  "L X+0",
  "L Z+1",
  "LBL 0",
  "END PGM LAW MM",
];

/** Parts that look ahead or return occur more often. */
const NAMES = [
  ...Object.keys(PARTS),
  "free",
  "freeTogether",
  "freeTogether",
  "jumped",
  "repeatedCycle",
  "repeatedCycle",
  "contour",
];

/** Programs composed of some parts. */
export const movingPrograms: fc.Arbitrary<string> = fc
  .array(fc.tuple(fc.constantFrom(...NAMES), fc.integer({ min: 1, max: 6 })), {
    minLength: 3,
    maxLength: 7,
  })
  .map((parts) => {
    const lines = parts.flatMap(([name, n], i) => PARTS[name]?.(i + 1, n) ?? []);
    return [...HEAD, ...tool(1, "M136"), ...lines, ...TAIL, ""].join("\n");
  });
