import type { Scan } from "./scan.ts";
import type { ContourArea, FileName, OutlinePlace, Parameter, Statement } from "./statement.ts";
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
const PLACE = String.raw`(?:(LBL[ \t]*)(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))|"([^"]*)"|(${TEXT_PARAMETER}))`;
const AREA = new RegExp(String.raw`([PIV])[ \t]*(\d{1,2})[ \t]*=?[ \t]*${PLACE}`, "iy");
const DEPTH = new RegExp(String.raw`DEPTH[ \t]*(${VALUE})`, "iy");
const named = (parameter: string): Parameter => ({ parameter: parameter.toUpperCase(), negative: false });

function placeFrom([lbl, digits, name, label, file, text]: readonly (string | undefined)[]): OutlinePlace {
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
    areas.push({ role, number: Number(m[2]), from: placeFrom(m.slice(3)), depth: depth && readValue(depth[1] ?? "") });
  }
  return areas.length > 0 && scan.done ? { kind: "contourDefinition", areas } : null;
}

const CONTOUR = String.raw`QC\d{1,4}(?!\d)`;
const DECLARED = new RegExp(String.raw`DECLARE[ \t]+CONTOUR[ \t]+(${CONTOUR})[ \t]*=[ \t]*${PLACE}`, "iy");
const FORMULA = new RegExp(String.raw`(${CONTOUR})[ \t]*=`, "iy");
const NAMED_CONTOUR = new RegExp(CONTOUR, "iy");
const [JOIN, OPEN, CLOSE] = [/[|&^\\]/y, /\(/y, /\)/y] as const;
/** Longer formulas are refused: nobody writes them. */
const LONGEST_FORMULA = 200;

/** `DECLARE CONTOUR QC1 = "POCKET.H" DEPTH5`, and `QC10 = ( QC1 | QC2 ) \ QC3`; null when it is neither. */
export function readContourFormula(scan: Scan): Statement | null {
  const declared = scan.take(DECLARED);
  if (declared) {
    const depth = scan.take(DEPTH);
    const [, contour = "", ...place] = declared;
    return scan.done
      ? {
          kind: "declareContour",
          contour: contour.toUpperCase(),
          from: placeFrom(place),
          depth: depth && readValue(depth[1] ?? ""),
        }
      : null;
  }
  const target = scan.take(FORMULA)?.[1]?.toUpperCase();
  const terms = target === undefined ? null : readTerms(scan);
  return target !== undefined && terms ? { kind: "contourFormula", target, terms } : null;
}

/** Contours with a sign between each two of them, and brackets that close; null for anything else. */
function readTerms(scan: Scan): string[] | null {
  const terms: string[] = [];
  let open = 0;
  for (let wantsContour = true; !scan.done;) {
    const m = scan.take(wantsContour ? NAMED_CONTOUR : JOIN) ?? scan.take(wantsContour ? OPEN : CLOSE);
    if (!m || terms.length >= LONGEST_FORMULA) return null;
    const term = m[0].toUpperCase();
    terms.push(term);
    if (term === "(") open += 1;
    else if (term === ")") open -= 1;
    else wantsContour = !wantsContour;
    if (open < 0) return null;
  }
  const last = terms.at(-1) ?? "";
  return open === 0 && (last === ")" || last.startsWith("QC")) ? terms : null;
}
