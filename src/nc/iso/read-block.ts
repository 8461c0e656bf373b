import { parse } from "../parse.ts";
import { readLabel, readValue, VALUE } from "../value.ts";
import type { Statement } from "../statement.ts";
import type { CycleParameter, Formula, Label, Parameter, Value } from "../words.ts";
import { coordinatesOf, dimensionOf } from "./coordinates.ts";
import type { IsoProblem } from "./issue.ts";
import { LONGEST_LINE } from "../longest-line.ts";
import type { IsoBlock } from "./lines.ts";
import type { IsoContext } from "./modal.ts";
import type { IsoNames } from "./names.ts";
import { olderCycleOfIso, programCycleOfIso } from "./older-cycles.ts";
import { JUMPS } from "./print-statement.ts";
import { readPathBlock, type ReadBlock } from "./read-path.ts";
import { isoTokens, type IsoToken } from "./tokens.ts";
import { FIRST_CYCLE, isoMeaningOf, type IsoMeaning } from "./words.ts";

/** A Klartext block inside a DIN/ISO program. */
const KLARTEXT = new RegExp(
  String.raw`^(?:(?:BEGIN|END)[ \t]+PGM|BLK[ \t]+FORM|TOOL[ \t]+(?:CALL|DEF)|CYCLE?[ \t]*(?:DEF|CALL)|CALL[ \t]|SEL[ \t]|LBL[ \t]|` +
    String.raw`(?:FUNCTION|TRANS|PLANE|APPR|DEP|UDC|GRV|FPOL|FSELECT|FLT|FL|FCT|FC|RND|CHF|CTP|CR|CT|CC|CP|LP|STOP|IF)(?![A-Z])|` +
    String.raw`(?:CONTOUR[ \t]+DEF|DECLARE)(?![A-Z])|FN[ \t]*\d|Q[LRSC]?\d+[ \t]*=|L[ \t]+[A-Z]|C[ \t]+[A-PR-Z])`,
  "i",
);
const INLINE_CYCLE = /^CYCLE?[ \t]*DEF[ \t]*(\d{1,9})(?![\d.])[ \t]*(.*)/i;
const ISO_CYCLE = /^G[ \t]*(\d{3})(?!\d)[ \t]*(.*)/i;
const BEFORE_PARAMETERS = /^(.*?)(?=(?:^|[ \t])Q[LR]?\d{1,4}(?!\d)|$)/i;
const NAME = /^[^\d=;+]*$/;
const CALL = new RegExp(
  String.raw`^L[ \t]*(?:(\d{1,9})|"([^"]*)"|(Q[LRS]?\d{1,4}))[ \t]*(?:,[ \t]*(${VALUE})[ \t]*)?$`,
  "i",
);
const PROGRAM = /^%[ \t]*(?:"([^"]*)"|(QS\d{1,4})|([^\s":<][^"]*))$/i;

/** A value is a label only as a whole number or parameter. */
function labelOf(token: IsoToken | undefined): Label | Parameter | null {
  if (!token) return null;
  return (
    token.text ?? (token.value === null || (typeof token.value === "number" && token.value < 0) ? null : token.value)
  );
}

function parametersOf(
  tokens: readonly IsoToken[],
  cycle: number,
  comment: string | null,
  names: IsoNames,
): CycleParameter[] | null {
  if (tokens.some((t) => t.letter !== "Q")) return null;
  return tokens.map((t, i) => {
    const q = t.text ?? "";
    const own = i === tokens.length - 1 ? comment : null;
    return { q, value: t.special ?? t.value, label: own ?? (names.label(cycle, q) || null) };
  });
}

/** A cycle with Q parameters, on one line or on several. */
function cycleBlock(
  cycle: number,
  rest: string,
  { comment, parameters: lines }: IsoBlock,
  names: IsoNames,
): Statement | null {
  const front = BEFORE_PARAMETERS.exec(rest)?.[1] ?? "";
  if (!NAME.test(front)) return null;
  const own = parametersOf(isoTokens(rest.slice(front.length)), cycle, lines.length > 0 ? null : comment, names);
  const more = lines.map((line) => parametersOf(isoTokens(line.text), cycle, line.comment, names));
  const all = [own, ...more].flatMap((p) => p ?? [null]);
  const parameters = all.filter((p) => p !== null);
  if (parameters.length < all.length) return null;
  return { kind: "cycle", cycle, name: front.trim() || names.cycle(cycle), parameters };
}

/** The number of the cycle that a G number calls; null when it calls none. */
function cycleNumber(code: number): number | null {
  const means = isoMeaningOf("G", code);
  if (means?.kind === "shiftedCycle") return means.cycle;
  return code >= FIRST_CYCLE ? code : null;
}

const SIGNS = { 1: "sum", 2: "difference", 3: "product", 4: "quotient", 8: "length", 13: "angle" } as const;
const CALLS = { 5: "SQRT", 6: "SIN", 7: "COS" } as const;

/** D00 to D14: functions, jumps and error messages. */
function parameterBlock(tokens: readonly IsoToken[]): Statement | null {
  const [head, target, ...rest] = tokens;
  const means = head?.letter === "D" ? isoMeaningOf("D", head.number ?? -1) : null;
  const values = (of: readonly IsoToken[], count: number): Value[] | null => {
    const read = of.flatMap((t, i) => (t.letter === "P" && t.number === i + 1 && t.value !== null ? [t.value] : []));
    return of.length === count && read.length === count ? read : null;
  };
  if (means?.kind === "block" && means.block === "raise") {
    const [error] = values(tokens.slice(1), 1) ?? [];
    return error === undefined ? null : { kind: "raise", error };
  }
  if (means?.kind === "jump") {
    const [left, right] = values(tokens.slice(1, 3), 2) ?? [];
    const label =
      tokens.length === 4 && tokens[3]?.letter === "P" && tokens[3].number === 3 ? labelOf(tokens[3]) : null;
    if (left === undefined || right === undefined || label === null) return null;
    return { kind: "jump", fn: means.fn, left, right, compare: JUMPS[means.fn], label };
  }
  if (means?.kind !== "function" || target?.letter !== "Q" || target.value !== null || target.text === null)
    return null;
  const { fn } = means;
  const of = (value: Value): Formula => ({ kind: "value", value });
  const assigned = (formula: Formula): Statement => ({ kind: "assign", fn, target: target.text ?? "", formula });
  const two = fn in SIGNS;
  const [left, right] = values(rest, two ? 2 : 1) ?? [];
  if (left === undefined) return null;
  if (fn === 0) return assigned(of(left));
  if (fn === 5 || fn === 6 || fn === 7) return assigned({ kind: "call", name: CALLS[fn], of: of(left) });
  return right === undefined ? null : assigned({ kind: SIGNS[fn], left: of(left), right: of(right) });
}

/** T: a tool call, with following M functions as a separate block. */
function toolCall(tokens: readonly IsoToken[]): Statement[] | null {
  const call: {
    -readonly [K in keyof Extract<Statement, { kind: "toolCall" }>]: Extract<Statement, { kind: "toolCall" }>[K];
  } = {
    kind: "toolCall",
    tool: null,
    axis: null,
    speed: null,
    feed: null,
    deltaLength: null,
    deltaRadius: null,
    extra: [],
  };
  const functions: number[] = [];
  for (const token of tokens) {
    const { letter, value, special, text } = token;
    const means = letter === "G" ? isoMeaningOf("G", token.number ?? -1) : null;
    if (letter === "T" && special === null) call.tool = text ?? value;
    else if (means?.kind === "plane") call.axis = means.axis;
    else if (letter === "S" && value !== null) call.speed = value;
    else if (/^F[UZ]?$/.test(letter) && (special ?? value) !== null)
      call.feed = special ?? { value: value ?? 0, unit: letter as "F" | "FU" | "FZ" };
    else if (letter === "DL" && value !== null) call.deltaLength = value;
    else if (letter === "DR" && value !== null) call.deltaRadius = value;
    else if (letter === "M" && typeof value === "number") functions.push(value);
    else return null;
  }
  const words = { axes: [], functions };
  return [call, ...(functions.length === 0 ? [] : [{ kind: "functions", words } as const])];
}

/** Blocks with a leading G word: label, tool definition, blank, older cycles. Null where their words do not fit. */
function wordBlock(means: IsoMeaning, tokens: readonly IsoToken[], names: IsoNames): Statement[] | null {
  const first = tokens.findIndex((t) => t.letter === "G" && isoMeaningOf("G", t.number ?? -1) === means);
  const rest = tokens.filter((t, i) => i !== first && dimensionOf(t) === null);
  const { coordinates } = coordinatesOf(tokens, false);
  if (means.kind === "olderCycle")
    return olderCycleOfIso(means.cycle, means.row ?? false, { tokens: rest, coordinates }, names);
  if (means.kind !== "block") return null;
  if (means.block === "label") {
    const label = rest.length === 1 && rest[0]?.letter === "L" ? labelOf(rest[0]) : null;
    if (label === null) return null;
    if (typeof label !== "object") return [{ kind: "label", label }];
    return label.parameter.startsWith("QS") ? [{ kind: "label", label: label.parameter }] : null;
  }
  if (means.block === "toolDefinition") {
    const of = (letter: string) => rest.find((t) => t.letter === letter);
    const tool = labelOf(of("T"));
    if (tool === null || typeof tool === "object" || rest.some((t) => !/^[TLR]$/.test(t.letter))) return null;
    return [{ kind: "toolDefinition", tool, length: of("L")?.value ?? null, radius: of("R")?.value ?? null }];
  }
  const axes = coordinates.flatMap(({ name, ...w }) =>
    /^[XYZABCUVW]$/.test(name) ? [{ axis: name as "X", ...w }] : [],
  );
  const planes = rest.flatMap((t) => {
    const plane = t.letter === "G" ? isoMeaningOf("G", t.number ?? -1) : null;
    return plane?.kind === "plane" ? [plane.axis] : [];
  });
  const corner = means.block === "blankMinimum" ? 1 : 2;
  if (axes.length + planes.length < rest.length || planes.length > 1 || (corner === 2 && planes.length > 0))
    return null;
  return [{ kind: "blankBox", corner, axis: planes[0] ?? null, axes }];
}

/** Words that decide the block kind, wherever they are in the block. */
const OWN: ReadonlySet<string> = new Set(["label", "toolDefinition", "blankMinimum", "blankMaximum"]);

const notUnderstood = (text: string): IsoProblem => ({
  code: "isoBlockNotUnderstood",
  at: 0,
  data: { text: text.slice(0, 60) },
});

/** A Klartext block inside a DIN/ISO program. */
function klartextBlock(text: string): Statement | null {
  const statement = parse(`0 ${text}`).blocks[0]?.statement;
  return !statement || statement.kind === "unknown" || statement.kind === "empty" ? null : statement;
}

/**
 * Reads one block, its frame aside. What is not understood has no statements and at least one problem; never throws.
 */
export function readIsoBlock(block: IsoBlock, { modal, names }: IsoContext): ReadBlock {
  const { text } = block;
  const done = (statements: readonly Statement[] | null): ReadBlock => ({
    statements,
    modal,
    problems: statements === null ? [notUnderstood(text)] : [],
  });
  const one = (statement: Statement | null) => done(statement && [statement]);
  if (text.length > LONGEST_LINE) return done(null);
  if (/^\*/.test(text)) return one({ kind: "structure", text: text.replace(/^\*[ \t]*-?/, "").trim() });
  const inline = INLINE_CYCLE.exec(text);
  if (inline)
    return one(
      cycleBlock(Number(inline[1]), inline[2] ?? "", block, inline[2] ? { ...names, cycle: () => "" } : names),
    );
  if (KLARTEXT.test(text)) return one(klartextBlock(text));
  const program = PROGRAM.exec(text);
  if (program) {
    const [, quoted, held, bare] = program;
    const file =
      held === undefined ? (quoted ?? (bare ?? "").trim()) : { parameter: held.toUpperCase(), negative: false };
    return one({ kind: "callProgram", file, bare: bare !== undefined });
  }
  const call = CALL.exec(text);
  if (call) {
    const label =
      call[3] === undefined ? readLabel(call[1], call[2]) : { parameter: call[3].toUpperCase(), negative: false };
    const repeat = call[4] === undefined ? null : readValue(call[4]);
    return one({ kind: "call", label, repeat: repeat === 0 ? null : repeat });
  }
  const cycle = ISO_CYCLE.exec(text);
  const number = cycle ? cycleNumber(Number(cycle[1])) : null;
  if (number !== null) return one(cycleBlock(number, cycle?.[2] ?? "", block, names));
  const called = programCycleOfIso(text, names);
  if (called) return done(called);
  const tokens = isoTokens(text);
  if (tokens[0]?.letter === "D") return one(parameterBlock(tokens));
  const own = tokens
    .map((t) => (t.letter === "G" ? isoMeaningOf("G", t.number ?? -1) : null))
    .find((m) => m?.kind === "olderCycle" || (m?.kind === "block" && OWN.has(m.block)));
  if (own) return done(wordBlock(own, tokens, names));
  if (tokens.some((t) => t.letter === "T")) return done(toolCall(tokens));
  return readPathBlock(text, tokens, modal);
}
