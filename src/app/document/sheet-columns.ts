import { z } from "zod/mini";
import { record } from "../base/record.ts";
import type { Assignment } from "../../program/tool-sheets/assignment.ts";

/** The assigned columns of a sheet of tools, by the titles of the sheet; `day` is when they were assigned. */
export interface AssignedSheet extends Assignment {
  readonly signature: string;
  readonly day: string;
}

/** Most sheets whose columns are remembered; the oldest is forgotten. */
const MOST = 30;
const text = z.string().check(z.maxLength(10_000));
const words = z.record(text, text);
const sheet = z.object({
  signature: text,
  day: text,
  columns: z.array(z.nullable(z.object({ cell: text, inch: z.boolean(), diameter: z.boolean() }))),
  words: z.object({ TYPE: words, TO: words }),
});

const NONE: readonly AssignedSheet[] = [];

/** The columns that were assigned on this device. */
export const sheetRecord = record({
  key: "tool-sheets",
  version: 1,
  schema: z.object({ sheets: z.array(sheet) }),
  rows: { of: "sheets", each: sheet },
  from: ({ sheets }) => sheets as readonly AssignedSheet[],
  to: (sheets) => ({ sheets }),
  first: NONE,
  document: "tools",
});

/** The columns that were assigned to sheets with these titles; undefined for none. */
export const assignedBefore = (signature: string): AssignedSheet | undefined =>
  sheetRecord.now().find((each) => each.signature === signature);

/** Adds sheets, the later ones instead of those with the same titles. */
export const mergedSheets = (
  mine: readonly AssignedSheet[],
  others: readonly AssignedSheet[],
): readonly AssignedSheet[] => {
  const signatures = new Set(others.map((each) => each.signature));
  return [...mine.filter((each) => !signatures.has(each.signature)), ...others].slice(-MOST);
};

export const rememberSheet = (assigned: AssignedSheet): void =>
  sheetRecord.put(mergedSheets(sheetRecord.now(), [assigned]));
