import { axisName, readWords } from "./read-words.ts";
import type { Scan } from "./scan.ts";
import type { FeedWord, Label, NamedWord, OutlineSource, Statement, Value } from "./statement.ts";
import { PARAMETER, parameterOf, readLabel, TEXT_PARAMETER, VALUE } from "./value.ts";

const named = (word: string) => new RegExp(String.raw`${word}[ \t]*(${VALUE})`, "iy");
const NUMBERED_OR_QUOTED = /(?:(\d{1,9}(?:[.,]\d)?)(?![\d.,])|"([^"]*)")/y;
const AXIS = /([XYZABCUVW])(?![A-Z])/iy;
const UNIT = /(?:^|\s)(MM|INCH)$/i;

/** `BEGIN PGM NAME MM`, `END PGM NAME MM`. */
export function readFrame(scan: Scan, kind: "begin" | "end"): Statement {
  const rest = scan.rest;
  const unit = UNIT.exec(rest.slice(-6));
  if (!unit) scan.missing("MM");
  scan.at = scan.text.length;
  const name = unit ? rest.slice(0, -unit[0].length).trim() : rest;
  return { kind, name, unit: unit?.[1]?.toUpperCase() === "INCH" ? "INCH" : "MM" };
}

const LBL = /LBL(?:_?OUT)?(?![A-Z_])/iy;
const INNER = /LBL_?IN(?![A-Z_])/iy;
const LABEL = /(?:(\d{1,9})|"([^"]*)")/y;

const CORNER = /0[.,]([12])(?![\d])/y;
const CYLINDER = /CYLINDER(?![A-Z])/iy;
const ROTATION = /ROTATION(?![A-Z])/iy;
const [D, R, L, DIST, DI, RI] = ["D", "R", "L", "DIST", "DI", "RI"].map(named) as [
  RegExp,
  RegExp,
  RegExp,
  RegExp,
  RegExp,
  RegExp,
];
const DIMENSION = /DIM_([DR])(?![A-Z])/iy;
const FILE = /FILE(?![A-Z])/iy;
const TARGET = /TARGET(?![A-Z])/iy;
const QUOTED = /"([^"]*)"/y;
const HELD = new RegExp(TEXT_PARAMETER, "iy");

/** The blank in one of its forms; null when it is none of them. */
export function readBlank(scan: Scan): Statement | null {
  const corner = scan.take(CORNER);
  if (corner) {
    const axis = corner[1] === "1" ? scan.take(AXIS_ALONE) : null;
    const words = readWords(scan);
    return {
      kind: "blankBox",
      corner: corner[1] === "1" ? 1 : 2,
      axis: axis ? axisName(axis[1] ?? "") : null,
      axes: words.axes,
    };
  }
  if (scan.take(CYLINDER)) return readCylinder(scan);
  if (scan.take(FILE)) return readBlankFile(scan);
  if (!scan.take(ROTATION)) return null;
  const axis = scan.take(AXIS);
  const measure = scan.take(DIMENSION);
  const outline = readOutline(scan);
  if (!outline || !axis) return null;
  const inner = labelBehind(scan, INNER);
  scan.leftOver();
  return {
    kind: "blankRotation",
    axis: axisName(axis[1] ?? ""),
    measure: measure?.[1]?.toUpperCase() === "R" ? "R" : "D",
    outline,
    inner,
  };
}
function labelBehind(scan: Scan, word: RegExp): Label | null {
  const m = scan.take(word) && scan.take(LABEL);
  return m && readLabel(m[1], m[2]);
}

/** An outline behind a label, or in a file, before which FILE may stand. */
export function readOutline(scan: Scan): OutlineSource | null {
  const label = labelBehind(scan, LBL);
  if (label !== null) return { label };
  scan.take(FILE);
  const file = scan.take(QUOTED);
  if (file) return { file: file[1] ?? "" };
  const held = scan.take(HELD);
  return held && { file: { parameter: held[0].toUpperCase(), negative: false } };
}

/** `BLK FORM FILE "BLANK.STL" TARGET "PART.STL"`. */
function readBlankFile(scan: Scan): Statement | null {
  const file = scan.take(QUOTED);
  if (!file) return null;
  const target = scan.take(TARGET) ? scan.take(QUOTED) : null;
  scan.leftOver();
  return { kind: "blankFile", file: file[1] ?? "", target: target?.[1] ?? null };
}
const AXIS_ALONE = /([XYZABCUVW])(?=[ \t]|$)/iy;

function readCylinder(scan: Scan): Statement | null {
  const axis = scan.take(AXIS);
  if (!axis) return null;
  let length: Value | null = null;
  let distance: Value | null = null;
  let outside: { measure: "D" | "R"; value: Value } | null = null;
  let inside: { measure: "DI" | "RI"; value: Value } | null = null;
  const value = (m: RegExpExecArray | null) => (m ? scan.value(m[1] ?? "") : null);
  for (;;) {
    let got: Value | null;
    if ((got = value(scan.take(DIST))) !== null) distance = got;
    else if ((got = value(scan.take(DI))) !== null) inside = { measure: "DI", value: got };
    else if ((got = value(scan.take(RI))) !== null) inside = { measure: "RI", value: got };
    else if ((got = value(scan.take(D))) !== null) outside = { measure: "D", value: got };
    else if ((got = value(scan.take(R))) !== null) outside = { measure: "R", value: got };
    else if ((got = value(scan.take(L))) !== null) length = got;
    else break;
  }
  scan.leftOver();
  if (!outside) scan.missing("D");
  if (length === null) scan.missing("L");
  return { kind: "blankCylinder", axis: axisName(axis[1] ?? ""), outside, length, distance, inside };
}

const TOOL_PARAMETER = new RegExp(String.raw`[+-]?[ \t]*${PARAMETER}`, "iy");
const [S, DL, DR, FEED_VALUE] = [
  named("S"),
  named("DL"),
  named("DR"),
  new RegExp(String.raw`(F[UZ]?)[ \t]*(${VALUE})`, "iy"),
] as const;
const FEED_WORD = /F[ \t]*(MAX|AUTO)(?![A-Z])/iy;

/** `TOOL CALL 5 Z S3000 F200 DL+0.1 DR+0.05`; without a tool only the speed, feed or deltas change. */
export function readToolCall(scan: Scan): Statement {
  const direct = scan.take(NUMBERED_OR_QUOTED);
  const parameter = direct ? null : scan.take(TOOL_PARAMETER);
  const tool = direct ? readLabel(direct[1]?.replace(",", "."), direct[2]) : parameter && parameterOf(parameter[0]);
  const axis = scan.take(AXIS);
  let [speed, deltaLength, deltaRadius] = [null, null, null] as (Value | null)[];
  let feed: FeedWord | null = null;
  const extra: string[] = [];
  const value = (m: RegExpExecArray | null, group = 1) => (m ? scan.value(m[group] ?? "") : null);
  while (!scan.done) {
    let got: Value | null;
    let m: RegExpExecArray | null;
    if ((got = value(scan.take(S))) !== null) speed = got;
    else if ((got = value(scan.take(DL))) !== null) deltaLength = got;
    else if ((got = value(scan.take(DR))) !== null) deltaRadius = got;
    else if ((m = scan.take(FEED_WORD))) feed = m[1]?.toUpperCase() === "MAX" ? "max" : "auto";
    else if ((got = value((m = scan.take(FEED_VALUE)), 2)) !== null)
      feed = { value: got, unit: (m?.[1] ?? "F").toUpperCase() as "F" | "FU" | "FZ" };
    else {
      const word = scan.word();
      extra.push(word);
      scan.issue({ code: "wordNotUnderstood", severity: "warning", data: { text: word.slice(0, 40) } }, word.length);
    }
  }
  return {
    kind: "toolCall",
    tool,
    axis: axis ? axisName(axis[1] ?? "") : null,
    speed: speed ?? null,
    feed,
    deltaLength: deltaLength ?? null,
    deltaRadius: deltaRadius ?? null,
    extra,
  };
}

/** `TOOL DEF 1 L+0 R+10`. */
export function readToolDefinition(scan: Scan): Statement | null {
  const tool = scan.take(NUMBERED_OR_QUOTED);
  if (!tool) return null;
  const length = scan.take(L);
  const radius = scan.take(R);
  scan.leftOver();
  return {
    kind: "toolDefinition",
    tool: readLabel(tool[1]?.replace(",", "."), tool[2]),
    length: length ? scan.value(length[1] ?? "") : null,
    radius: radius ? scan.value(radius[1] ?? "") : null,
  };
}

const NAMED = new RegExp(String.raw`([A-Z_]+?)[ \t]*:?[ \t]*(${VALUE})`, "iy");

/** Words of the form NAME and value, with or without a colon between them. */
export function readNamedWords(scan: Scan): NamedWord[] {
  const words: NamedWord[] = [];
  for (let m = scan.take(NAMED); m; m = scan.take(NAMED)) {
    const value = scan.value(m[2] ?? "");
    if (value !== null) words.push({ name: (m[1] ?? "").toUpperCase(), value });
  }
  scan.leftOver();
  return words;
}
