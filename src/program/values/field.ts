import type { Param } from "../../cycles/params.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import type { Value } from "../../nc/words.ts";
import { parameterOf } from "../../nc/value.ts";
import { type KnownParameters, readExpression, spelling } from "./expression.ts";

/**
 * Rules of one field, wherever it is typed: a prompt, a word of a block, the set-up, a row, a cell of the tool table.
 */
export interface Field {
  /** Place of its findings: a Q number, a word, "start.x", a column. */
  readonly id: string;
  /** Kind of its value, which gives the unit; "number" has none. */
  readonly kind: Param["kind"] | "number";
  readonly range: readonly [min: number, max: number];
  readonly choices?: readonly number[];
  /** May stay empty. */
  readonly optional: boolean;
  /** Decimals kept; null keeps the value as typed. */
  readonly decimals: number | null;
  /** With a leading I the value is incremental. */
  readonly increments?: boolean;
  /** A feed that may be FMAX. */
  readonly rapid?: boolean;
}

/** Reading of a field. An empty field is never 0. */
export interface FieldReading {
  /** The rounded number; null without one, and for FAUTO and FMAX. */
  readonly value: number | null;
  /** The same in NC terms: a single Q parameter stays a parameter. */
  readonly written: Value | "auto" | "max" | null;
  readonly incremental: boolean;
  /** True for a sum: on blur the field shows its value. */
  readonly computed: boolean;
  readonly empty: boolean;
  /** The issue, with the nearest valid value. */
  readonly issue: Issue | null;
}

/** Reading of an empty field. */
export const emptyReading: FieldReading = {
  value: null,
  written: null,
  incremental: false,
  computed: false,
  empty: true,
  issue: null,
};
export const rejectedReading = (found: Issue): FieldReading => ({ ...emptyReading, empty: false, issue: found });

/** An optional number without limits. */
export const anyNumber: Field = {
  id: "",
  kind: "number",
  range: [-Infinity, Infinity],
  optional: true,
  decimals: null,
};

/** A number rounded to the control's resolution; never −0. */
export const roundedTo = (n: number, decimals: number): number => Number(n.toFixed(decimals)) || 0;

const nearestOf = (choices: readonly number[], n: number) =>
  choices.reduce((best, next) => (Math.abs(next - n) < Math.abs(best - n) ? next : best));

/** Members of a field that limit its numbers. */
type Taken = Pick<Field, "id" | "range" | "choices"> & Partial<Pick<Field, "kind">>;

/** Issue of a number in a field, with the nearest valid one; null when valid. */
export function checkNumber({ id, kind, range: [min, max], choices }: Taken, n: number): Issue | null {
  if (choices)
    return choices.includes(n)
      ? null
      : issue("notAChoice", "error", { value: n, choices, nearest: nearestOf(choices, n) }, id);
  const within = Math.min(max, Math.max(min, n));
  if (!(n >= min && n <= max)) return issue("outOfRange", "error", { value: n, min, max, nearest: within }, id);
  return kind === "count" && !Number.isInteger(n)
    ? issue("notWhole", "error", { value: n, nearest: Math.round(n) }, id)
    : null;
}

/** FAUTO and FMAX as typed: with or without the F, in any case. */
export function feedWord(typed: string): "auto" | "max" | null {
  const word = /^(?:f\s*)?(auto|max)$/i.exec(typed.trim())?.[1]?.toLowerCase();
  return word === "auto" || word === "max" ? word : null;
}

/** The only conversion from typed text to a value. Empty stays missing; unreadable text is reported, never guessed. */
export function readText(field: Field, typed: string, known: KnownParameters = {}): FieldReading {
  const text = typed.trim();
  if (text === "") return { ...emptyReading, issue: field.optional ? null : issue("missing", "error", {}, field.id) };
  const word = field.kind === "feed" ? feedWord(text) : null;
  if (word === "auto" || (word === "max" && field.rapid)) return { ...emptyReading, empty: false, written: word };
  const incremental = field.increments === true && /^I/i.test(text);
  const bare = incremental ? text.slice(1) : text;
  const read = readExpression(bare, known);
  const parameter = parameterOf(spelling(bare));
  switch (read.kind) {
    case "number": {
      const value = field.decimals === null ? read.value : roundedTo(read.value, field.decimals);
      const found = checkNumber(field, value);
      return found
        ? rejectedReading(found)
        : { value, written: parameter ?? value, incremental, computed: read.computed, empty: false, issue: null };
    }
    case "unknownParameter":
      return {
        ...rejectedReading(issue("unknownParameter", "error", { name: read.name }, field.id)),
        incremental,
        written: parameter,
      };
    default:
      return {
        ...rejectedReading(
          issue(read.kind === "badExpression" ? "badExpression" : "notANumber", "error", { text }, field.id),
        ),
        written: parameter,
      };
  }
}

/** Result of a typed sum, as text; null for anything else. It replaces the sum on blur. */
export function sumOf(typed: string): string | null {
  const { computed, value } = readText({ ...anyNumber, decimals: 6 }, typed);
  return computed && value !== null ? String(value) : null;
}
