import { findCycles, findUnoffered } from "../../src/app/fields/chooser/search.ts";
import { lineEndsOf, toEditor } from "../../src/app/fields/blocks/line-ends.ts";
import { partsOf } from "../../src/app/fields/blocks/program-parts.ts";
import { placesIn } from "../../src/app/fields/find/text-places.ts";
import { matchesIn } from "../../src/app/fields/find/text-search.ts";
import { splitNegativeNumbers } from "../../src/app/base/negative-numbers.ts";
import { parseAddress } from "../../src/app/place/address.ts";
import { refusals } from "../../src/control-file/refusals.ts";
import { possibleFaults } from "../../src/course/made/faults.ts";
import { typedNumber, typedPlace } from "../../src/course/predicted-answers.ts";
import { everySlip } from "../../src/course/judge/possible-slips.ts";
import { wordMarks } from "../../src/course/judge/word-rule.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { readThread, threadsNamed } from "../../src/kernel/thread/threads.ts";
import { renumbered } from "../../src/nc/edit.ts";
import { isIsoText } from "../../src/nc/iso/lines.ts";
import { isoProgramText } from "../../src/nc/iso/print-iso.ts";
import { klartextOfIso } from "../../src/nc/iso/read-iso.ts";
import { withListTildes } from "../../src/nc/list-tildes.ts";
import { parse } from "../../src/nc/parse.ts";
import { issuesOf, print } from "../../src/nc/program.ts";
import { incrementalParser } from "../../src/nc/reread.ts";
import { LAYOUTS } from "../../src/nc/style.ts";
import { tokensOf } from "../../src/nc/tokens.ts";
import { readClamping } from "../../src/program/clamping/read-clamping.ts";
import { comparePrograms } from "../../src/program/compare/compare.ts";
import { byOperation } from "../../src/program/compare/by-operation.ts";
import { readDxfFile } from "../../src/program/drawing/dxf/read-dxf.ts";
import { readStep } from "../../src/program/drawing/step/read-step.ts";
import { readSvg } from "../../src/program/drawing/svg/read-svg.ts";
import { roleOfName } from "../../src/program/drawing/roles.ts";
import { operationsOf } from "../../src/program/edits/operations.ts";
import { readLibraryFile } from "../../src/program/edits/own-library.ts";
import { readPart21 } from "../../src/program/files/part21.ts";
import { readXml } from "../../src/program/files/xml.ts";
import { readHolderCode, readBarCode } from "../../src/program/iso-codes/holder-code.ts";
import { readInsertCode } from "../../src/program/iso-codes/insert-code.ts";
import { readToolCodes } from "../../src/program/iso-codes/tool-code.ts";
import { readMakerCode } from "../../src/program/iso-codes/maker-code.ts";
import { isoNames } from "../../src/program/job/iso-names.ts";
import { readUndercutName } from "../../src/program/job/undercut-name.ts";
import { readMachine } from "../../src/program/machine/machine-file.ts";
import { mainOf } from "../../src/program/run/main-program.ts";
import { run } from "../../src/program/run/run.ts";
import { readToolFiles } from "../../src/program/tool-files/read-tool-files.ts";
import { proposedAssignment } from "../../src/program/tool-sheets/assignment.ts";
import { readSheet } from "../../src/program/tool-sheets/sheet.ts";
import { meaningOfTitle, unitIn } from "../../src/program/tool-sheets/column-words.ts";
import { readCuttingTable } from "../../src/program/tools/cutting-table.ts";
import { readHead } from "../../src/program/tools/holder-cells.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { readTableCsv } from "../../src/program/tools/tool-table-csv.ts";
import { readToolFile } from "../../src/program/tools/tool-table-json.ts";
import { readTableText } from "../../src/program/tools/tool-table-text.ts";
import { readExpression } from "../../src/program/values/expression.ts";
import { typedFeed, typedValue } from "../../src/program/values/typed-value.ts";

/** What stands around a repeated text. */
export type Frames = readonly (readonly [front: string, behind: string])[];

/** A reader of text that a user can type, paste, open or be sent. */
export interface Reader {
  readonly name: string;
  readonly read: (text: string) => unknown;
  /** What stands around the repeated text for this reader to come to it, in addition to nothing. */
  readonly frames?: Frames;
  /** What ends the growth of a reader that is not linear below it. */
  readonly bound?: string;
  /** Repeated texts that only this reader tells apart. */
  readonly pumps?: readonly string[];
}

const bytes = (text: string) => new TextEncoder().encode(text);
const names = isoNames(ncLabels("en"));
const ONE_LINE: Frames = [["0 BEGIN PGM A MM\n1 ", "!\n2 END PGM A MM\n"]];
const PROGRAM: Frames = [
  ...ONE_LINE,
  ["L X", "!"],
  ["CYCL DEF 812 A ~\nQ215=+0 ", " ~\n!\n"],
  ["CYCL DEF 812 ", "\nQ215=+0\n"],
] as const;
const shop = { tools: shippedTools, mills: [], refused: new Map(), rapid: 10_000 } as const;

export const READERS: readonly Reader[] = [
  { name: "parse", read: (text) => issuesOf(parse(text)).length, frames: PROGRAM },
  { name: "print", read: (text) => print(parse(text)), frames: ONE_LINE },
  {
    name: "reread",
    read: (text) => {
      const again = incrementalParser();
      again(text);
      return again(`${text}\nL X1\n`);
    },
    frames: ONE_LINE,
  },
  {
    name: "tokens",
    read: tokensOf,
    frames: [
      ["1 L X", "!"],
      ["CYCL DEF 812 ", "!"],
    ],
  },
  { name: "parts", read: (text) => partsOf(parse(text), null), frames: PROGRAM },
  { name: "operations", read: (text) => operationsOf(parse(text)), frames: PROGRAM },
  {
    name: "compare",
    read: (text) => {
      const [a, b] = [parse(text), parse(`L X5\n${text}L Z3\n`)];
      return byOperation(a, b, comparePrograms(a, b));
    },
    frames: PROGRAM,
  },
  { name: "run", read: (text) => run(parse(text), shop), frames: PROGRAM },
  { name: "places", read: (text) => placesIn(parse(text), "Q2"), frames: PROGRAM },
  { name: "searched text", read: (text) => placesIn(parse("1 L X5\nLBL 1\n"), text) },
  { name: "find", read: (text) => matchesIn(text, "L X") },
  { name: "find blanks", read: (text) => matchesIn(text, "L  =") },
  { name: "found text", read: (text) => matchesIn("1 L X+5\n2 L  X+5\n", text) },
  { name: "cycles", read: (text) => [findCycles([], text, []), findUnoffered([], text, [])] },
  { name: "renumber", read: (text) => renumbered(parse(text), 1), frames: ONE_LINE },
  { name: "list tildes", read: (text) => withListTildes(parse(text)), frames: PROGRAM },
  { name: "iso text", read: isIsoText },
  {
    name: "iso program",
    read: (text) => klartextOfIso(text, LAYOUTS.tnc7, names),
    frames: [
      ["%A G71 *\nN10 ", "!*\n"],
      ["%A G71 *\nN10 G812 ", "!\n"],
      ["%A G71 *\nG", "!\n"],
      ["%", "G71"],
      ["% ", "!"],
    ],
    pumps: ["G01 X+5*\n", "N10 G00 ", "Q200=+1 ", "G812 Q200=+1 ~\nQ201=+2\n", "%A G71\n"],
  },
  { name: "iso print", read: (text) => isoProgramText(parse(text)), frames: PROGRAM },
  { name: "refusals", read: (text) => refusals(text, "tnc640"), frames: PROGRAM },
  { name: "refusals iso", read: (text) => refusals(text, "iso"), frames: [["%A G71 *\nN10 ", "!*\n"]] },
  {
    name: "main program",
    read: (text) =>
      mainOf(
        [
          { name: "a.h", text },
          { name: "b.h", text: "" },
        ],
        parse,
      ),
  },
  {
    name: "expression",
    read: (text) => readExpression(text),
    frames: [
      ["1+", "!"],
      ["Q1*", "("],
    ],
  },
  {
    name: "typed value",
    read: (text) => [typedValue(text), typedFeed(text)],
    frames: [
      ["F", "!"],
      ["FU", "x"],
    ],
  },
  {
    name: "thread",
    read: (text) => [readThread(text), threadsNamed(text, 5)],
    frames: [
      ["M20x", "!"],
      ["Tr ", "LH!"],
    ],
  },
  {
    name: "undercut",
    read: readUndercutName,
    frames: [
      ["DIN 509 ", "!"],
      ["DIN76-", "!"],
    ],
  },
  {
    name: "clamping",
    read: readClamping,
    frames: [
      ["CLAMPING ", "!"],
      ["CLAMPING FACE Z", "!"],
    ],
  },
  { name: "insert code", read: readInsertCode, frames: [["CNMG 12", "!"]] },
  { name: "holder code", read: (text) => [readHolderCode(text), readBarCode(text)], frames: [["PCLNR ", "!"]] },
  { name: "tool codes", read: (text) => [readToolCodes(text), readMakerCode(text)], frames: [["CNMG120408 ", "!"]] },
  { name: "cells of heads", read: readHead },
  { name: "machine", read: readMachine, frames: [['{"format":"turnwise-machine/1","name":"', '"}']] },
  { name: "cutting table", read: readCuttingTable },
  { name: "own cycles", read: readLibraryFile },
  {
    name: "tool table",
    read: readTableText,
    frames: [
      ["BEGIN TOOL .T MM", "!\n"],
      ["BEGIN TOOLTURN .TRN MM VERSION:'1'\nT NAME ZL XL TYPE TO RS\n1 ", "!\n[END]\n"],
      ["BEGIN TOOLTURN .TRN MM\nT NAME ", "!\n[END]\n"],
    ],
  },
  {
    name: "tool csv",
    read: readTableCsv,
    frames: [
      ["T;NAME;TYPE;ZL\n1;", "!\n"],
      ['T,NAME\n1,"', "\n"],
    ],
  },
  {
    name: "tool json",
    read: readToolFile,
    frames: [
      ['{"tools":[', "]}"],
      ["BEGIN ", "!"],
    ],
  },
  {
    name: "sheet",
    read: (text) => ((sheet) => sheet && proposedAssignment(sheet))(readSheet(text)),
    frames: [
      ["T;Name;Typ\n1;", ";3\n"],
      ["T;", "\n1;2;3\n"],
    ],
  },
  { name: "titles", read: (text) => [meaningOfTitle(text), unitIn(text)] },
  {
    name: "tool file",
    read: (text) => ["a.csv", "a.t"].map((name) => readToolFiles([{ name, text }], "mm")),
    frames: [
      ["<?xml version='1.0'?><a b='", "'/>"],
      ["<tool-library><tool ", "></tool-library>"],
      ["ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=", ";\nENDSEC;"],
      ["BEGIN\nKEY=", "!\n"],
      ["T1 P1 D", "!\n"],
    ],
  },
  {
    name: "dxf",
    read: (text) => readDxfFile(bytes(text)),
    frames: [
      ["0\nSECTION\n2\nENTITIES\n0\nTEXT\n1\n", "\n0\nENDSEC\n0\nEOF\n"],
      ["0\nSECTION\n2\nENTITIES\n", "0\nENDSEC\n0\nEOF\n"],
      ["999\n", "\n0\nSECTION\n"],
    ],
    pumps: [
      "999\nA\n",
      "0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n",
      "0\nLWPOLYLINE\n10\n1\n20\n2\n",
      "\\A",
      "\\S1^",
      "{\\H1;",
      "8\nDASHDOT\n",
    ],
  },
  {
    name: "step",
    read: (text) => readStep(bytes(text)),
    frames: [
      ["ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=", ";\nENDSEC;\nEND-ISO-10303-21;\n"],
      ["", "ISO-10303-21;"],
    ],
    pumps: ["/**/", "/* */\n", "#2=POINT('',(1.,2.));\n", "A((", "''", "\\X2\\", "\\X\\4"],
  },
  {
    name: "part 21",
    read: readPart21,
    frames: [["ISO-10303-21;\nDATA;\n#1=A('", "');\n"]],
    pumps: ["((", "#1=A(#1);\n"],
  },
  {
    name: "xml",
    read: readXml,
    frames: [
      ["<a>", "</a>"],
      ["<a ", ">"],
    ],
    pumps: ["<a>", "<a/>", "&amp;", "<!--", "<![CDATA[", "a='b' ", "&"],
  },
  {
    name: "svg",
    read: (text) => readSvg(bytes(text)),
    frames: [
      ["<svg><path d='", "'/></svg>"],
      ["<svg><path transform='", "' d='M0 0L1 1'/></svg>"],
      ["<svg><style>", "</style></svg>"],
      ["<svg>", "</svg>"],
      ["<svg width='", "'/>"],
      ["<svg><polyline points='", "'/></svg>"],
      ["<svg><path d='M0 0L1 1' style='", "'/></svg>"],
    ],
    pumps: [
      "M0 0",
      "L1 1 ",
      "1,",
      "scale(1)",
      "a{",
      "/*",
      "<g>",
      "<g/>",
      "<path d='M0 0L1 1'/>",
      "a{b:c}",
      "m1-1-1",
      "A1 1 0 0 0 1 1",
    ],
  },
  { name: "line roles", read: roleOfName, frames: [["DASHDOT", "!"]], pumps: ["DASHDOT", "DASH DOT"] },
  { name: "negative numbers", read: splitNegativeNumbers },
  { name: "line ends", read: (text) => toEditor(text, lineEndsOf(text)) },
  {
    name: "address",
    read: parseAddress,
    frames: [
      ["#h1=", ""],
      ["#/work/", ""],
    ],
  },
  { name: "answers", read: (text) => [typedNumber(text), typedPlace(text)] },
  { name: "faults", read: (text) => possibleFaults(text.split("\n")), frames: [["1 L", "Z"]] },
  { name: "slips", bound: "500 blocks", read: (text) => everySlip(text), frames: [["CYCL DEF 812 ~\nQ460=+1", "\n"]] },
  { name: "words", read: (text) => wordMarks(["M136", "CYCL DEF 812"], text) },
];
