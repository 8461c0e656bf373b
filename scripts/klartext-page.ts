import { parse } from "../src/nc/parse.ts";
import type { Statement } from "../src/nc/statement.ts";
import { filesByName } from "../src/program/state/program-files.ts";
import { hasEffect, run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

/** Blocks as programs contain them, for each kind of statement that the reader knows. */
const BLOCKS: Readonly<Record<Statement["kind"], readonly string[]>> = {
  empty: [""],
  comment: ["; TEXT"],
  structure: ["* - TEXT"],
  begin: ["BEGIN PGM NAME MM"],
  end: ["END PGM NAME MM"],
  blankBox: ["BLK FORM 0.1 Z X-40 Y-40 Z-90"],
  blankCylinder: ["BLK FORM CYLINDER Z D80 L100 DIST+0 DI20"],
  blankRotation: ["BLK FORM ROTATION Z DIM_D LBL 7", 'BLK FORM ROTATION Z DIM_R "BLANK.H"'],
  blankFile: ['BLK FORM FILE "BLANK.STL"'],
  toolDefinition: ["TOOL DEF 2", "TOOL DEF 7 L+0 R+5"],
  toolCall: ["TOOL CALL 2", 'TOOL CALL "DNMG-55-R04"', "TOOL CALL S1200"],
  mode: ["FUNCTION MODE TURN", "FUNCTION MODE MILL"],
  spin: ["FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500", "FUNCTION TURNDATA SPIN VCONST:OFF S900"],
  turnCorrection: ["FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1"],
  turnBlank: ["FUNCTION TURNDATA BLANK LBL 7", 'FUNCTION TURNDATA BLANK "BLANK.H"', "FUNCTION TURNDATA BLANK OFF"],
  path: [
    "L X+70 Z+3 FMAX",
    "CC X+40 Z-5",
    "CR X+60 Z-5 R+8 DR+",
    "CT X+60 Z-5",
    "LP PR+20 PA+30",
    "CP PA+40 DR+",
    "CTP PR+20 PA+30",
    "RND R2",
  ],
  chamfer: ["CHF 2"],
  approach: ["APPR LT X+60 Z+2 LEN4 RL F0.2", "DEP LN LEN4"],
  free: ["FL X+10 AN+30"],
  undercut: ["UDC TYPE_E R0.6 DEPTH0.3 LEN2.5"],
  groove: ["GRV RADIAL POS-20 BREADTH5 DEPTH3"],
  label: ["LBL 3", "LBL 0"],
  call: ["CALL LBL 7", "CALL LBL 7 REP2"],
  cycleLine: ["CYCL DEF 7.1 Z-20", "CYCL DEF 9.1 V.ZEIT 0.5", "CYCL DEF 10.1 ROT+30", "CYCL DEF 19.1 A+10"],
  cycle: [
    "CYCL DEF 812 SHOULDER, LONG. EXT. ~\n Q215=+0",
    "CYCL DEF 247 PRESETTING ~\n Q339=+1",
    "CYCL DEF 880 GEAR HOBBING ~\n Q215=+0",
  ],
  cycleCall: ["CYCL CALL", "CYCL CALL PAT", "CYCL CALL POS X+0 Y+0 Z+0"],
  selectContour: ['SEL CONTOUR "PART.H"'],
  contourDefinition: ["CONTOUR DEF P1 = LBL 7", 'CONTOUR DEF P1 = LBL 7 I2 = "PART.H" DEPTH5'],
  declareContour: ['DECLARE CONTOUR QC1 = "POCKET.H" DEPTH5'],
  contourFormula: ["QC10 = ( QC1 | QC2 ) \\ QC3"],
  raise: ["FN 14: ERROR=1000"],
  callProgram: ["CALL PGM DRILL.H"],
  selectProgram: ['SEL PGM "DRILL.H"'],
  callSelected: ["CALL SELECTED PGM"],
  jump: ["FN 9: IF +Q1 EQU +0 GOTO LBL 7", "IF Q1 > 3 GOTO LBL 7"],
  datum: ["TRANS DATUM AXIS Z-20", "TRANS DATUM RESET"],
  datumTable: ["TRANS DATUM TABLE TABLINE3"],
  mirror: ["TRANS MIRROR AXIS X"],
  rotation: ["TRANS ROTATION ROT+30"],
  scale: ["TRANS SCALE SCL0.99"],
  plane: ["PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX", "PLANE RESET STAY"],
  assign: ["FN 0: Q1 =+3", "Q1 = SIN 30 + 2", "QL2 = 4 * 3"],
  assignText: ['QS1 = "DRILL" || ".H"'],
  functions: ["M8", "M136", "M140 MB MAX"],
  stop: ["STOP"],
  unknown: [
    "FN 18: SYSREAD Q1 = ID20 NR1",
    "TCH PROBE 410",
    "FN 17: SYSWRITE ID20 NR1 =+1",
    "FN 16: F-PRINT A.A / B.TXT",
    "FUNCTION RESET TCPM",
    "SQL BIND Q1",
  ],
};

/** Treatment of a block: run; kept without effect; or kept, with the program unverified from there on. */
export const TREATMENTS = ["run", "kept", "unverified"] as const;
export type Treatment = (typeof TREATMENTS)[number];

const PLACES = {
  turning: [
    "FUNCTION MODE TURN",
    "FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX2000",
    "M136",
    "L X+80 Z+5 R0 F0.3",
    "CC X+30 Z+0",
    "L X+70 Z+2",
  ],
  milling: ["FUNCTION MODE MILL", "CC X+30 Y+0", "L X+60 Y+0 Z+20 R0 F400", "L X+50 Z+5"],
} as const;

/** Blocks that another block needs before it. */
const FIRST: Readonly<Record<string, readonly string[]>> = { "CALL SELECTED PGM": ['SEL PGM "DRILL.H"'] };
/** Blocks whose effect shows only when a cycle uses the contour that they name. */
const TAKEN: ReadonlySet<Statement["kind"]> = new Set(["selectContour", "contourDefinition"]);
const TAKING = {
  turning: [
    "L X+90 FMAX",
    "CYCL DEF 820 TURN CONTOUR TRANSV. ~\nQ215=+0 ~\nQ460=+2 ~\nQ499=+0 ~\nQ463=+2 ~\nQ478=+0.3 ~\nQ483=+0 ~\nQ484=+0 ~\n" +
      "Q505=+0.2 ~\nQ479=+0 ~\nQ480=+0 ~\nQ482=+0 ~\nQ506=+0 ~\nQ487=+0 ~\nQ488=+0",
    "CYCL CALL",
  ],
  milling: ["CYCL DEF 22 ROUGH-OUT ~\nQ10=+5", "CYCL CALL"],
} as const;

/** Files next to the small program. */
const FILES = filesByName(
  [
    { name: "DRILL.H", text: "0 BEGIN PGM DRILL MM\n1 L IZ+5 FMAX\n2 END PGM DRILL MM\n" },
    {
      name: "PART.H",
      text: "0 BEGIN PGM PART MM\n1 L X+70 Z-9\n2 L X+50\n3 L Z+0\n4 END PGM PART MM\n",
    },
  ],
  parse,
);

/** The treatment of a block in a small program. */
function treatmentOf(block: string, place: keyof typeof PLACES): Treatment {
  const first = FIRST[block] ?? [];
  const before = ["BEGIN PGM K MM", "BLK FORM CYLINDER Z D80 L100 DIST+0", "TOOL CALL 1", ...PLACES[place], ...first];
  const behind = ["L X+62 IZ+1", "M30", "LBL 7", "L X+70 Z-9", "L X+50", "L Z+0", "LBL 0", "END PGM K MM"];
  // A cycle has an effect only when called, a contour only when a cycle uses it.
  const kind = parse(`0 ${block}`).blocks[0]?.statement.kind ?? "empty";
  const called = TAKEN.has(kind)
    ? TAKING[place]
    : block.startsWith("CYCL DEF") && block.includes("~")
      ? ["CYCL CALL"]
      : [];
  const text = [...before, block, ...called, ...behind].map((b, i) => `${i} ${b}`).join("\n");
  const program = parse(text);
  const statement = program.blocks[before.length]?.statement;
  if (!statement || !hasEffect(statement.kind)) return "kept";
  const { unproved, issues } = run(program, {
    tools: shippedTools,
    rapid: 10_000,
    control: "TNC 640",
    refused: new Map(),
    files: FILES,
  });
  if (unproved.some(({ block: at }) => at !== null && at >= before.length && at <= before.length + called.length))
    return "unverified";
  const silent =
    statement.kind === "unknown" || issues.some((f) => f.issue.code === "notSimulated" && f.block === before.length);
  return silent ? "kept" : "run";
}

const HEAD = `# Blocks of a program

Every kind of block that the reader knows, in one of its spellings, and what happens to it in turning and in milling mode:

- **run**: it does what it does on the control.
- **kept**: it is saved unchanged to the byte and affects neither path nor stock.
- **unverified**: it is saved unchanged to the byte. Its effect is not simulated, and the program is unverified from that block on.

UDC and GRV are run in a contour. DRILL.H and PART.H are beside the program; a missing program or contour is unverified. A block that
is not in the list is kept as text and unverified.
The page is written by \`npm run docs\`: each block is run in a small program.

| Block | Turning | Milling |
|---|---|---|
`;

/** The page of all kinds of blocks. */
export function klartextPage(): string {
  const rows = Object.values(BLOCKS)
    .flat()
    .filter((b) => b !== "")
    .map((b) => {
      const shown = (b.split("\n")[0] ?? "").replace(" ~", " …").replaceAll("|", "\\|");
      return `| \`${shown}\` | ${treatmentOf(b, "turning")} | ${treatmentOf(b, "milling")} |\n`;
    });
  return HEAD + rows.join("");
}
