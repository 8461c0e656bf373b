import type { AxisWord, CycleParameter, FeedWord, Value } from "../../nc/words.ts";
import type { KnownParameters } from "./expression.ts";
import { anyNumber, feedWord, roundedTo, readText } from "./field.ts";

/** Decimals a control keeps of a position. */
export const POSITION_DECIMALS = 3;

/**
 * A typed number as a value of NC text, rounded to the control's resolution; null for anything else. A Q parameter
 * stays one; a sum with Q parameters is evaluated, since NC text has no sums there.
 */
export function typedValue(typed: string, decimals = POSITION_DECIMALS, known: KnownParameters = {}): Value | null {
  const { written } = readText({ ...anyNumber, decimals }, typed, known);
  return written === "auto" || written === "max" ? null : written;
}

/** The word of an axis, when a number is typed for it. */
export const typedAxis = (name: "X" | "Y" | "Z", typed: string, incremental = false): AxisWord[] => {
  const read = typedValue(typed);
  return read === null ? [] : [{ axis: name, value: read, incremental }];
};

/** Decimals of a number that is typed into a block. */
const BLOCK_DECIMALS = 4;
/** A number that is typed into a block. */
export const blockValue = (typed: string, decimals = BLOCK_DECIMALS): Value | null => typedValue(typed, decimals);

/** A value of NC text as typed: no plus sign; empty without one. */
export function valueAsTyped(value: Value | null | undefined): string {
  if (value === null || value === undefined) return "";
  return typeof value === "number" ? String(value) : (value.negative ? "-" : "") + value.parameter;
}

/** A position as typed, rounded to the control's resolution. */
export const positionAsTyped = (n: number): string => String(roundedTo(n, POSITION_DECIMALS));

/** Value of a cycle parameter as typed. */
export const parameterAsTyped = (value: CycleParameter["value"] | undefined): string =>
  typeof value === "string" ? `F${value.toUpperCase()}` : valueAsTyped(value);

/** A feed as typed. */
export function feedAsTyped(feed: FeedWord | null | undefined): string {
  if (feed === null || feed === undefined) return "";
  if (feed === "max" || feed === "auto") return `F${feed.toUpperCase()}`;
  return (feed.unit === "F" ? "" : feed.unit) + valueAsTyped(feed.value);
}

/** A typed feed: empty, FMAX, FAUTO, or a number with optional F, FU or FZ; undefined when unreadable. */
export function typedFeed(typed: string): FeedWord | null | undefined {
  const text = typed.trim();
  if (text === "") return null;
  const word = feedWord(text);
  if (word) return word;
  const [, unit = "F", rest = ""] = /^(F[UZ]?)?(.*)$/i.exec(text) ?? [];
  const value = blockValue(rest);
  return value === null ? undefined : { value, unit: unit.toUpperCase() as "F" | "FU" | "FZ" };
}
