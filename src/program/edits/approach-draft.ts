import { issue } from "../../kernel/plan/issue.ts";
import type { Statement } from "../../nc/statement.ts";
import type { FeedWord, PolarWord, Value, Words } from "../../nc/words.ts";
import { approachFields, type ApproachField, type ApproachWord, type WorkingPlane } from "../motion/approach-fields.ts";
import type { KnownParameters } from "../values/expression.ts";
import { emptyReading, readText, rejectedReading, type FieldReading } from "../values/field.ts";
import { feedAsTyped, valueAsTyped } from "../values/typed-value.ts";

export type ApproachStatement = Extract<Statement, { kind: "approach" }>;
/** Typed text of each prompt of an approach. SIDE holds "RL", "RR" or "R0". */
export type ApproachDraft = Readonly<Partial<Record<ApproachWord, string>>>;

export const SIDES = ["RL", "RR", "R0"] as const;

/** A statement in the form of typed text. */
export function approachDraft({ words }: ApproachStatement): ApproachDraft {
  const coordinate = (w: PolarWord | undefined) => (w ? (w.incremental ? "I" : "") + valueAsTyped(w.value) : "");
  const axis = (name: "X" | "Y" | "Z") => coordinate(words.axes.find((w) => w.axis === name));
  return {
    X: axis("X"),
    Y: axis("Y"),
    Z: axis("Z"),
    PR: coordinate(words.polarRadius),
    PA: coordinate(words.polarAngle),
    LEN: valueAsTyped(words.length),
    CCA: valueAsTyped(words.centreAngle),
    R: valueAsTyped(words.radius),
    SIDE: words.compensation ?? "",
    F: typeof words.feed === "object" ? valueAsTyped(words.feed.value) : feedAsTyped(words.feed),
    M: words.functions.map((m) => `M${m}`).join(" "),
  };
}

/** M functions as typed: `M8 M303`, or `8 303`; null where one is invalid. */
export function typedFunctions(typed: string): readonly number[] | null {
  const text = typed.trim();
  const list = text === "" ? [] : text.split(/[\s,]+/).map((each) => /^M?\s*(\d{1,4})$/i.exec(each)?.[1]);
  return list.includes(undefined) ? null : list.map(Number);
}

/** Reads one word. Empty stays empty; an invalid value comes with the nearest valid one. */
export function readWord(f: ApproachField, typed: string, known: KnownParameters = {}): FieldReading {
  const { id, kind } = f;
  const text = typed.trim();
  if (kind === "side")
    return text === "" ? emptyReading : { ...emptyReading, empty: false, value: SIDES.findIndex((s) => s === text) };
  if (kind === "functions")
    return typedFunctions(text) ? emptyReading : rejectedReading(issue("notANumber", "error", { text }, id));
  const read = readText({ ...f, kind }, kind === "feed" ? text.replace(/^F\s*(?=\d)/i, "") : text, known);
  // The value of a parameter is known at run time only, so an unknown one is no fault here.
  return read.issue?.code === "unknownParameter" && read.written !== null ? { ...read, issue: null } : read;
}

export type ApproachReading = Readonly<Partial<Record<ApproachWord, FieldReading>>>;

/** Reads all prompts of a form. */
export function readApproach(
  s: Pick<ApproachStatement, "form" | "departing">,
  plane: WorkingPlane,
  draft: ApproachDraft,
  known: KnownParameters = {},
): ApproachReading {
  const readings = approachFields(s.form, s.departing, plane).map(
    (f) => [f.id, readWord(f, draft[f.id] ?? "", known)] as const,
  );
  return Object.fromEntries(readings);
}

/**
 * Block of the typed text. An unreadable word keeps its value in `base`; words without a prompt (a third axis in
 * turning, unknown words) stay.
 */
export function approachStatement(
  base: ApproachStatement,
  plane: WorkingPlane,
  draft: ApproachDraft,
  known: KnownParameters = {},
): ApproachStatement {
  const readings = readApproach(base, plane, draft, known);
  const old = base.words;
  const failed = (w: ApproachWord) => (readings[w]?.issue ?? null) !== null && (draft[w] ?? "").trim() !== "";
  const value = (w: ApproachWord, before: Value | undefined): Value | undefined => {
    const written = readings[w]?.written ?? undefined;
    return failed(w) || typeof written === "string" ? before : written;
  };
  const coordinate = (w: ApproachWord, before: PolarWord | undefined): PolarWord | undefined => {
    const written = value(w, undefined);
    if (failed(w)) return before;
    return written === undefined ? undefined : { value: written, incremental: readings[w]?.incremental ?? false };
  };
  const across = plane === "ZX" ? "Y" : "Z";
  const axes = (["X", "Y", "Z"] as const).flatMap((axis) => {
    const before = old.axes.find((w) => w.axis === axis);
    // An axis without a prompt stays, unless the point is polar and the axis is in its plane.
    const c = readings[axis] ? coordinate(axis, before) : readings.PR && axis !== across ? undefined : before;
    return c ? [{ axis, value: c.value, incremental: c.incremental }] : [];
  });
  const [polarRadius, polarAngle] = [coordinate("PR", old.polarRadius), coordinate("PA", old.polarAngle)];
  const [centreAngle, length, radius] = [
    value("CCA", old.centreAngle),
    value("LEN", old.length),
    value("R", old.radius),
  ];
  const compensation = SIDES.find((s) => s === draft.SIDE);
  const feed = failed("F") ? old.feed : feedOf(readings.F, old.feed);
  const functions = typedFunctions(draft.M ?? "") ?? old.functions;
  const words: Words = {
    axes: [...axes, ...old.axes.filter((w) => !["X", "Y", "Z"].includes(w.axis))],
    functions,
    ...(old.linear && { linear: old.linear }),
    ...(old.extra && { extra: old.extra }),
    ...(polarRadius && { polarRadius }),
    ...(polarAngle && { polarAngle }),
    ...(centreAngle !== undefined && { centreAngle }),
    ...(length !== undefined && { length }),
    ...(radius !== undefined && { radius }),
    ...(!base.departing && compensation && { compensation }),
    ...(feed !== undefined && { feed }),
    ...(old.retract !== undefined && { retract: old.retract }),
  };
  return { kind: "approach", departing: base.departing, form: base.form, words };
}

/** Typed feed; FU and FZ keep their unit. */
function feedOf(read: FieldReading | undefined, before: FeedWord | undefined): FeedWord | undefined {
  const written = read?.written ?? null;
  if (written === null) return undefined;
  if (written === "auto" || written === "max") return written;
  return { value: written, unit: typeof before === "object" ? before.unit : "F" };
}
