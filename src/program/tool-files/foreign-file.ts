import { readJson } from "../files/bounded.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import type { FileTool, RefusedItem } from "./facts.ts";

/** A text of a set of files that were chosen together or packed into one. */
export interface NamedText {
  readonly name: string;
  readonly text: string;
}

/** What a file of another system contains, before its tools are made rows of the table. */
export interface ForeignContent {
  readonly tools: readonly FileTool[];
  readonly refused: readonly RefusedItem[];
  /** Whether lengths were read whose unit is not in the file. */
  readonly unitAsked: boolean;
  /** Whether the file ends before its end. */
  readonly cutShort?: boolean;
}

/** What a reader needs besides the text of its file. */
export interface ReadingContext {
  readonly name: string;
  /** Unit of lengths whose unit is not in the file. */
  readonly unit: LengthUnit;
  /** Text of another file of the set by the end of its path; reading one takes it out of the set. */
  readonly sibling: (path: string) => string | null;
}

/** Reads the text of one file; null when it is not of the format. Never throws. */
export type ForeignReader = (text: string, context: ReadingContext) => ForeignContent | null;

/** Most items that one file may bring; the rest is refused as a whole by the caller. */
export const MOST_ITEMS = 5000;

export const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** JSON of a text; undefined for anything else. */
export function jsonOf(text: string): unknown {
  const bare = text.replace(/^\uFEFF/, "").trimStart();
  if (!/^[{[]/.test(bare)) return undefined;
  try {
    return readJson(bare);
  } catch {
    return undefined;
  }
}
