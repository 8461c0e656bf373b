import type { Scan } from "./scan.ts";
import type { ContourArea, FileName, Parameter, Statement } from "./statement.ts";
import { PARAMETER, readLabel, readValue, TEXT_PARAMETER, VALUE } from "./value.ts";

const QUOTED = /"([^"]*)"/y;
const NAMED = new RegExp(`(${TEXT_PARAMETER})`, "iy");
const BARE_NAME = /[^\s;"][^;"]*/y;

/** The file that a block names: in quotes, bare up to the end of the line, or by a parameter. */
function readFileName(scan: Scan): { readonly file: FileName; readonly bare: boolean } | null {
  const quoted = scan.take(QUOTED);
  if (quoted) return { file: quoted[1] ?? "", bare: false };
  const from = scan.at;
  const held = scan.take(NAMED);
  if (held && scan.done) return { file: named(held[1] ?? ""), bare: false };
  scan.at = from;
  const name = scan.take(BARE_NAME)?.[0].trim() ?? "";
  return name === "" ? null : { file: name, bare: true };
}

const SELECTED = /(?:CALL[ \t]+SELECTED[ \t]+(?:PGM|PROGRAM)|CALL[ \t]+SELECTED(?![ \t]*\S))/iy;
const CALL_PROGRAM = /CALL[ \t]+PGM(?![A-Z])/iy;
const SELECT_PROGRAM = /SEL[ \t]+PGM(?![A-Z])/iy;
const SELECT_CONTOUR = /SEL[ \t]+CONTOUR(?![A-Z])/iy;

/** Blocks that name another program, or call the one that was named. */
export function readProgramBlock(scan: Scan): Statement | null {
  if (scan.take(SELECTED)) {
    scan.leftOver();
    return { kind: "callSelected" };
  }
  const kind = scan.take(CALL_PROGRAM) ? "callProgram" : scan.take(SELECT_PROGRAM) ? "selectProgram" : null;
  if (kind) {
    const name = readFileName(scan);
    if (!name) return null;
    scan.leftOver();
    return { kind, ...name };
  }
  if (!scan.take(SELECT_CONTOUR)) return null;
  const name = readFileName(scan);
  if (!name || name.bare) return null;
  scan.leftOver();
  return { kind: "selectContour", file: name.file };
}

const CONTOUR_DEFINITION = /CONTOUR[ \t]+DEF(?![A-Z])/iy;
const AREA = new RegExp(
  String.raw`([PIV])[ \t]*(\d{1,2})[ \t]*=?[ \t]*(?:(LBL[ \t]*)(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))|"([^"]*)"|(${TEXT_PARAMETER}))`,
  "iy",
);
const DEPTH = new RegExp(String.raw`DEPTH[ \t]*(${VALUE})`, "iy");
const named = (parameter: string): Parameter => ({ parameter: parameter.toUpperCase(), negative: false });

function areaFrom([, , , lbl, digits, name, label, file, text]: RegExpExecArray): ContourArea["from"] {
  if (lbl !== undefined) return { label: label === undefined ? readLabel(digits, name) : named(label) };
  return { file: text === undefined ? (file ?? "") : named(text) };
}

/** `CONTOUR DEF P1 = LBL 1 I2 = "PIN.H" DEPTH5`: the areas of a pocket, each by a label or a file. */
export function readContourDefinition(scan: Scan): Statement | null {
  if (!scan.take(CONTOUR_DEFINITION)) return null;
  const areas: ContourArea[] = [];
  for (let m = scan.take(AREA); m; m = scan.take(AREA)) {
    const role = (m[1] ?? "P").toUpperCase() as ContourArea["role"];
    const depth = scan.take(DEPTH);
    areas.push({ role, number: Number(m[2]), from: areaFrom(m), depth: depth && readValue(depth[1] ?? "") });
  }
  return areas.length > 0 && scan.done ? { kind: "contourDefinition", areas } : null;
}
