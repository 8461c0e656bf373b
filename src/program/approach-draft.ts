import { issue, type Issue } from "../kernel/issue.ts";
import type { Feed, Statement, Value, Words } from "../nc/statement.ts";
import { parameterOf } from "../nc/value.ts";
import { approachFields, type ApproachField, type ApproachWord, type WorkingPlane } from "./approach-fields.ts";
import { readExpression, type KnownParameters } from "./expression.ts";

export type ApproachStatement = Extract<Statement, { kind: "approach" }>;
/** What was typed into each prompt of an approach. SIDE holds "RL", "RR" or "R0". */
export type ApproachDraft = Readonly<Partial<Record<ApproachWord, string>>>;

/** What one typed word says. */
export interface WordReading {
  readonly value: number | null;
  readonly incremental: boolean;
  /** The word as a statement holds it: a number or a Q parameter. */
  readonly written: Value | null;
  readonly issue: Issue | null;
}

export const SIDES = ["RL", "RR", "R0"] as const;

const number = (text: string) => Number(text);
const textOf = (value: Value): string => (typeof value === "number" ? String(value) : (value.negative ? "-" : "") + value.parameter);
const axisText = (w: { readonly value: Value; readonly incremental: boolean } | undefined): string => (w ? (w.incremental ? "I" : "") + textOf(w.value) : "");

function feedWord(feed: Feed | undefined): string {
  if (feed === undefined) return "";
  return feed === "max" ? "FMAX" : feed === "auto" ? "FAUTO" : textOf(feed.value);
}

/** What a statement says, as it would have been typed. */
export function approachDraft({ words }: ApproachStatement): ApproachDraft {
  const axis = (name: "X" | "Y" | "Z") => axisText(words.axes.find((w) => w.axis === name));
  return {
    X: axis("X"), Y: axis("Y"), Z: axis("Z"), PR: axisText(words.polarRadius), PA: axisText(words.polarAngle),
    LEN: words.length === undefined ? "" : textOf(words.length),
    CCA: words.centreAngle === undefined ? "" : textOf(words.centreAngle),
    R: words.radius === undefined ? "" : textOf(words.radius),
    SIDE: words.compensation ?? "", F: feedWord(words.feed), M: words.functions.map((m) => `M${m}`).join(" "),
  };
}

const nothing: WordReading = { value: null, incremental: false, written: null, issue: null };
const wrong = (found: Issue): WordReading => ({ ...nothing, issue: found });

/** Reads one word. Empty stays empty; what is wrong is said with the nearest value that works. */
export function readWord(f: ApproachField, typed: string, known: KnownParameters = {}): WordReading {
  const text = typed.trim();
  if (text === "") return f.optional ? nothing : wrong(issue("missing", "error", {}, f.word));
  if (f.unit === "side") return SIDES.some((s) => s === text) ? { ...nothing, value: SIDES.findIndex((s) => s === text) } : nothing;
  if (f.unit === "functions") {
    const list = text.split(/[\s,]+/).map((m) => /^M?(\d{1,4})$/i.exec(m)?.[1]);
    return list.includes(undefined) ? wrong(issue("notANumber", "error", { text }, f.word)) : { ...nothing, value: list.length };
  }
  if (f.unit === "feed" && /^F?\s*(MAX|AUTO)$/i.test(text)) return { ...nothing, value: 0 };
  const incremental = f.incremental && /^I/i.test(text);
  const bare = incremental ? text.slice(1) : f.unit === "feed" ? text.replace(/^F\s*(?=\d)/i, "") : text;
  const parameter = parameterOf(bare);
  const read = readExpression(bare, known);
  if (read.kind === "unknownParameter" && parameter) return { ...nothing, incremental, written: parameter };
  if (read.kind === "unknownParameter") return wrong(issue("unknownParameter", "error", { name: read.name }, f.word));
  if (read.kind !== "number") return wrong(issue(read.kind === "badExpression" ? "badExpression" : "notANumber", "error", { text }, f.word));
  if (!f.schema.safeParse(read.value).success) {
    const [min, max] = f.range;
    return wrong(issue("outOfRange", "error", { value: read.value, min, max, nearest: Math.min(max, Math.max(min, read.value)) }, f.word));
  }
  return { value: read.value, incremental, written: parameter ?? read.value, issue: null };
}

export type ApproachReading = Readonly<Partial<Record<ApproachWord, WordReading>>>;

/** Reads all prompts of a form. */
export function readApproach(
  s: Pick<ApproachStatement, "form" | "departing">, plane: WorkingPlane, draft: ApproachDraft, known: KnownParameters = {},
): ApproachReading {
  const readings = approachFields(s.form, s.departing, plane).map((f) => [f.word, readWord(f, draft[f.word] ?? "", known)] as const);
  return Object.fromEntries(readings);
}

function feedOf(text: string, read: WordReading | undefined): Feed | undefined {
  if (/^F?\s*MAX$/i.test(text.trim())) return "max";
  if (/^F?\s*AUTO$/i.test(text.trim())) return "auto";
  return read && read.written !== null ? { value: read.written, unit: "F" } : undefined;
}

/**
 * The block of what was typed. A word that can not be read keeps what `base` said; words without a prompt (a third axis in
 * turning, words nobody knows) stay as they are.
 */
export function approachStatement(base: ApproachStatement, plane: WorkingPlane, draft: ApproachDraft, known: KnownParameters = {}): ApproachStatement {
  const readings = readApproach(base, plane, draft, known);
  const asked = new Set(approachFields(base.form, base.departing, plane).map((f) => f.word));
  const old = base.words;
  const failed = (w: ApproachWord) => (readings[w]?.issue ?? null) !== null && (draft[w] ?? "").trim() !== "";
  const coordinate = (w: ApproachWord) => {
    const r = readings[w];
    return r && r.written !== null ? { value: r.written, incremental: r.incremental } : undefined;
  };
  const axes = (["X", "Y", "Z"] as const).flatMap((axis) => {
    if (!asked.has(axis) || failed(axis)) return old.axes.filter((w) => w.axis === axis && !(asked.has("PR") && axis !== "Z"));
    const c = coordinate(axis);
    return c ? [{ axis, ...c }] : [];
  });
  const value = (w: ApproachWord, before: Value | undefined) => (failed(w) ? before : (readings[w]?.written ?? undefined));
  const polarRadius = failed("PR") ? old.polarRadius : coordinate("PR");
  const polarAngle = failed("PA") ? old.polarAngle : coordinate("PA");
  const centreAngle = value("CCA", old.centreAngle);
  const length = value("LEN", old.length);
  const radius = value("R", old.radius);
  const compensation = SIDES.find((s) => s === draft.SIDE);
  const read = feedOf(draft.F ?? "", readings.F);
  const feed = failed("F") ? old.feed : read && typeof read === "object" && typeof old.feed === "object" ? { ...read, unit: old.feed.unit } : read;
  const functions = failed("M") ? old.functions : (draft.M ?? "").trim() === "" ? [] : (draft.M ?? "").trim().split(/[\s,]+/).map((m) => number(m.replace(/^M/i, "")));
  const words: Words = {
    axes: [...axes, ...old.axes.filter((w) => !["X", "Y", "Z"].includes(w.axis))], linear: old.linear, functions, extra: old.extra,
    ...(polarRadius && { polarRadius }), ...(polarAngle && { polarAngle }),
    ...(centreAngle !== undefined && { centreAngle }), ...(length !== undefined && { length }), ...(radius !== undefined && { radius }),
    ...(!base.departing && compensation && { compensation }), ...(feed !== undefined && { feed }),
    ...(old.retract !== undefined && { retract: old.retract }),
  };
  return { kind: "approach", departing: base.departing, form: base.form, words };
}
