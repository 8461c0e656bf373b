import type { BlockIssue } from "./program.ts";
import { readCycle, type BlockLine } from "./read-cycle.ts";
import { readAssignment } from "./read-formula.ts";
import { readBlank, readFrame, readNamedWords, readToolCall, readToolDefinition } from "./read-frame.ts";
import { readFunction } from "./read-function.ts";
import { readFree } from "./read-free.ts";
import { JUMP, readJump, readRaise } from "./read-jump.ts";
import { readContourDefinition, readContourFormula, readProgramBlock } from "./read-program.ts";
import { readTextAssignment, TEXT_ASSIGNMENT } from "./read-text.ts";
import { readTrans, type TransWord } from "./read-trans.ts";
import { readWords } from "./read-words.ts";
import { Scan } from "./scan.ts";
import {
  APPROACH_FORMS,
  FREE_FORMS,
  type ApproachForm,
  type PathKind,
  type Statement,
  type Words,
} from "./statement.ts";
import { NUMBER_PARAMETER, PARAMETER, readLabel, TEXT_PARAMETER, VALUE } from "./value.ts";

const KEYWORD = new RegExp(
  String.raw`(?:(CYCLE?[ \t]*(?:DEF|CALL)|BEGIN[ \t]+PGM|END[ \t]+PGM|BLK[ \t]+FORM|TOOL[ \t]+(?:CALL|DEF)|CALL[ \t]+LBL|` +
    String.raw`TRANS[ \t]+(?:DATUM|MIRROR|ROTATION|SCALE)|PLANE|` +
    String.raw`FUNCTION|FSELECT|FPOL|FLT|FCT|FL|FC|LBL|STOP|APPR|DEP|UDC|GRV|RND|CHF|CTP|CR|CT|CC|CP|LP|L|` +
    String.raw`C(?![ \t]*[+\-.\d]))(?![A-Z_]))`,
  "iy",
);
const ASSIGNMENT = new RegExp(String.raw`(?:FN[ \t]*(?:[0-8]|13)[ \t]*:|${NUMBER_PARAMETER}[ \t]*=)`, "iy");
const FUNCTIONS = /M\d/iy;
/** A paraxial block: a coordinate without L. */
const PARAXIAL = new RegExp(String.raw`I?[XYZABCUVW][ \t]*${VALUE}`, "iy");
const LABEL = /(?:(\d{1,9})|"([^"]*)")/y;
const NAMED_LABEL = new RegExp(`()(${TEXT_PARAMETER})`, "iy");
const LABEL_PARAMETER = new RegExp(`(${PARAMETER})`, "iy");
const REPEAT = new RegExp(String.raw`REP[ \t]*(${VALUE})(?:[ \t]*/[ \t]*\d+)?`, "iy");
const BARE = new RegExp(VALUE, "iy");
const FORM = /(P?L?(?:LT|LN|CT))(?![A-Z])/iy;
const UNDERCUT = /(TYPE[ \t]*_[ \t]*[A-Z]|THREAD)(?![A-Z])/iy;
const GROOVE = /(RADIAL|AXIAL)(?![A-Z])/iy;
const HOW = /(POS|PAT)(?![A-Z])/iy;
const TILTED_TOOL = /^(?:RESET[ \t]+)?TCPM(?![A-Z])/i;
/** Besides cycles the only blocks that a control writes on several lines. */
const WRAPPED = /^[ \t]*CONTOUR[ \t]+DEF(?![A-Z])/i;
const PATHS: ReadonlySet<string> = new Set<PathKind>(["L", "C", "CR", "CT", "CTP", "LP", "CP", "CC"]);

/** Characters of one line; what is longer is no block of a control and would fill the memory word by word. */
const LONGEST = 10_000;

export interface Read {
  readonly statement: Statement;
  readonly issues: readonly BlockIssue[];
}

/** What a block says. Whatever is not understood is kept as `unknown` with one issue. */
export function readStatement(lines: readonly BlockLine[]): Read {
  const head = lines[0];
  if (!head) return { statement: { kind: "empty" }, issues: [] };
  const isWrapped = WRAPPED.test(head.text);
  const scan = new Scan(isWrapped ? joined(lines) : head.text, head.offset);
  if (scan.done && lines.length === 1)
    return {
      statement: head.comment === null ? { kind: "empty" } : { kind: "comment", text: head.comment },
      issues: [],
    };
  const issues: BlockIssue[] = [];
  const statement = head.text.length > LONGEST ? null : dispatch(scan, lines, issues);
  if (!statement || (lines.length > 1 && statement.kind !== "cycle" && !isWrapped)) {
    const text = lines.map((l) => l.text.trim()).join(" ");
    const whole: BlockIssue = {
      code: "notUnderstood",
      severity: "info",
      offset: head.offset,
      length: head.text.trimEnd().length,
      data: { text: text.slice(0, 60) },
    };
    return { statement: { kind: "unknown", text }, issues: [whole] };
  }
  for (const i of scan.issues) issues.push(i);
  return { statement, issues };
}

/** The lines of one block as one text in which everything stands at its own place; comments are left out. */
const joined = (lines: readonly BlockLine[]): string =>
  lines.reduce((text, line) => text.padEnd(line.offset - (lines[0]?.offset ?? 0)) + line.text, "");

function dispatch(scan: Scan, lines: readonly BlockLine[], issues: BlockIssue[]): Statement | null {
  const keyword = scan.take(KEYWORD);
  if (!keyword) return withoutKeyword(scan);
  const word = keyword[0].toUpperCase();
  if (PATHS.has(word)) return path(scan, word as PathKind);
  const free = FREE_FORMS.find((form) => form === word);
  if (free) return readFree(scan, free);
  switch (word.replace(/^CYCLE?[ \t]*/, "CYCL ").replace(/[ \t]+/, " ")) {
    case "CYCL DEF":
      return readCycle(scan, lines, issues);
    case "CYCL CALL": {
      const how = scan.take(HOW);
      return { kind: "cycleCall", how: (how?.[1]?.toUpperCase() ?? "") as "" | "POS" | "PAT", words: readWords(scan) };
    }
    case "BEGIN PGM":
      return readFrame(scan, "begin");
    case "END PGM":
      return readFrame(scan, "end");
    case "BLK FORM":
      return readBlank(scan);
    case "TOOL CALL":
      return readToolCall(scan);
    case "TOOL DEF":
      return readToolDefinition(scan);
    case "FUNCTION":
      return readFunction(scan) ?? (TILTED_TOOL.test(scan.rest) ? kept(scan, "FUNCTION") : null);
    case "RND":
      return rounding(scan);
    case "CHF":
      return chamfer(scan);
    case "APPR":
      return approach(scan, false);
    case "DEP":
      return approach(scan, true);
    case "UDC": {
      const form = scan.take(UNDERCUT);
      return (
        form && {
          kind: "undercut",
          form: (form[1] ?? "").replace(/[ \t]/g, "").toUpperCase(),
          words: readNamedWords(scan),
        }
      );
    }
    case "GRV": {
      const form = scan.take(GROOVE);
      return (
        form && {
          kind: "groove",
          form: form[1]?.toUpperCase() === "AXIAL" ? "AXIAL" : "RADIAL",
          words: readNamedWords(scan),
        }
      );
    }
    case "LBL":
      return label(scan);
    case "CALL LBL":
      return call(scan);
    case "TRANS DATUM":
    case "TRANS MIRROR":
    case "TRANS ROTATION":
    case "TRANS SCALE":
      return readTrans(scan, word.replace(/^TRANS[ \t]+/, "") as TransWord);
    case "PLANE":
      return kept(scan, "PLANE");
    case "STOP":
      return { kind: "stop", words: readWords(scan) };
    default:
      return null;
  }
}

/** A block whose words only what runs it looks at. */
function kept(scan: Scan, word: string): Statement {
  const text = `${word} ${scan.rest}`.trimEnd();
  scan.at = scan.text.length;
  return { kind: "plane", text };
}

function withoutKeyword(scan: Scan): Statement | null {
  if (scan.take(/\*/y)) {
    scan.take(/-/y);
    const text = scan.rest;
    scan.at = scan.text.length;
    return { kind: "structure", text };
  }
  const from = scan.at;
  if (scan.take(ASSIGNMENT)) {
    scan.at = from;
    return readAssignment(scan);
  }
  if (scan.take(TEXT_ASSIGNMENT)) {
    scan.at = from;
    return readTextAssignment(scan);
  }
  if (scan.take(JUMP)) {
    scan.at = from;
    return readJump(scan);
  }
  if (scan.take(PARAXIAL)) {
    scan.at = from;
    return path(scan, "L");
  }
  if (scan.take(FUNCTIONS)) {
    scan.at = from;
    return { kind: "functions", words: readWords(scan) };
  }
  return readRaise(scan) ?? readProgramBlock(scan) ?? readContourDefinition(scan) ?? readContourFormula(scan);
}

/** A line that starts with the letter of a path function and has none of its words is something else. */
const saysNothing = (words: Words) =>
  words.extra.length > 0 &&
  words.axes.length + words.functions.length + words.linear.length === 0 &&
  Object.keys(words).length === 4;

function path(scan: Scan, kind: PathKind): Statement | null {
  const words = readWords(scan, kind === "CR");
  if (saysNothing(words)) return null;
  if (kind === "CR" && words.radius === undefined) scan.missing("R");
  if ((kind === "CR" || kind === "C" || kind === "CP") && words.turn === undefined) scan.missing("DR");
  return { kind: "path", path: kind, words };
}

function rounding(scan: Scan): Statement {
  const bare = scan.take(BARE);
  const value = bare && scan.value(bare[0]);
  const words = readWords(scan, true);
  if (value === null && words.radius === undefined) scan.missing("R");
  return { kind: "path", path: "RND", words: value === null ? words : { ...words, radius: value } };
}

function chamfer(scan: Scan): Statement {
  const bare = scan.take(BARE);
  const length = bare && scan.value(bare[0]);
  const words = readWords(scan);
  if (length === null) scan.missing("CHF");
  return { kind: "chamfer", length, words };
}

function approach(scan: Scan, departing: boolean): Statement | null {
  const m = scan.take(FORM);
  const form = APPROACH_FORMS.find((f) => f === m?.[1]?.toUpperCase()) as ApproachForm | undefined;
  return form ? { kind: "approach", departing, form, words: readWords(scan) } : null;
}

function label(scan: Scan): Statement | null {
  const m = scan.take(LABEL) ?? scan.take(NAMED_LABEL);
  if (!m) return null;
  scan.leftOver();
  return { kind: "label", label: readLabel(m[1] || undefined, m[2]) };
}

function call(scan: Scan): Statement | null {
  const m = scan.take(LABEL);
  const parameter = m ? null : scan.take(LABEL_PARAMETER);
  if (!m && !parameter) return null;
  const times = scan.take(REPEAT);
  const repeat = times && scan.value(times[1] ?? "");
  scan.leftOver();
  const target = parameter
    ? { parameter: (parameter[1] ?? "").toUpperCase(), negative: false }
    : readLabel(m?.[1], m?.[2]);
  return { kind: "call", label: target, repeat };
}
