import { z } from "zod/mini";
import { measure } from "../../program/files/bounded.ts";
import { CLAMPING_KINDS } from "../../program/clamping/words.ts";
import type { ClampingChanges } from "../../planning/working-plan.ts";
import { newPart, type FinishedPart } from "../../planning/part/finished-part.ts";
import { randomId } from "../base/random-id.ts";
import { record } from "../base/record.ts";
import { uniqueIds } from "../base/unique.ts";
import { PARTS } from "../document/documents.ts";
import { editRecord } from "../document/edit-record.ts";
import { contourRow } from "./save-file.ts";

/** A finished part of this device as typed, and what the operator has excluded from its plans. */
export interface StoredPart {
  readonly id: string;
  readonly part: FinishedPart;
  /** Tools by number. */
  readonly withoutTools: readonly number[];
  readonly withoutCycles: readonly number[];
  /** What its newest plan keeps of each clamping when it is planned again, as after a reload. */
  readonly first?: PlanDecisions;
  readonly second?: PlanDecisions;
}

/** Operations of a plan by their keys, in their order, and those that are locked with the values set by hand. */
export type PlanDecisions = Required<Pick<ClampingChanges, "keep" | "hand">>;
export const NO_DECISIONS: PlanDecisions = { keep: [], hand: {} };
export type Clamping = "first" | "second";

export type PartList = readonly StoredPart[];

/** Most operations that are noted of a plan. */
const MOST_KEYS = 200;
const text = z.string().check(z.maxLength(500));
const rows = z.array(contourRow).check(z.maxLength(2000));
const number = z.optional(measure);
const mark = z.object({
  thread: z.optional(text),
  undercut: z.optional(text),
  tolerance: z.optional(text),
  ra: number,
  rz: number,
});
const rules = z.object({
  toolChange: number,
  usualTool: number,
  finishBeforeRough: number,
  insideBeforeOutside: number,
  thinBeforeLong: number,
  tolerancedLast: number,
  allowance: z.optional(z.object({ diameter: measure, z: measure })),
});
const part = z.object({
  name: text,
  material: text,
  outside: rows,
  inside: rows,
  marks: z.record(text, mark),
  general: z.object({ tolerance: z.optional(text), ra: number, rz: number }),
  blank: z.nullable(
    z.union([z.object({ outline: rows }), z.object({ outside: text, bore: text, length: text, allowance: text })]),
  ),
  clamping: z.nullable(z.object({ kind: z.enum(CLAMPING_KINDS), words: z.record(z.string(), text) })),
  partsOff: z.boolean(),
  unmachinedBehind: z.boolean(),
  rules,
});
const excluded = z.array(measure).check(z.maxLength(2000));
const key = z.string().check(z.maxLength(2000));
const decisions = z.optional(
  z.object({
    keep: z.array(key).check(z.maxLength(MOST_KEYS)),
    hand: z.record(key, z.record(z.string(), measure)),
  }),
);
const stored = z.object({
  id: text,
  part,
  withoutTools: excluded,
  withoutCycles: excluded,
  first: decisions,
  second: decisions,
});

const NONE: PartList = [];

/** The finished parts of this device, the last opened one first. */
export const partRecord = record({
  key: "parts",
  document: PARTS,
  version: 1,
  schema: z.object({ parts: z.array(stored).check(uniqueIds) }),
  rows: { of: "parts", each: stored },
  from: ({ parts }) => parts as PartList,
  to: (parts) => ({ parts }),
  first: NONE,
});
export const useParts = partRecord.use;

/** Restored parts that are missing here are added. */
export const mergedParts = (mine: PartList, brought: PartList): PartList => {
  const known = new Set(mine.map(({ id }) => id));
  return [...mine, ...brought.filter(({ id }) => !known.has(id))];
};

/** Changes the open part as one step of undo; successive changes at the same place are one step. */
export const editPart = (change: (part: StoredPart) => StoredPart, place: string | null = null): void =>
  editRecord(partRecord, ([open, ...others]) => (open ? [change(open), ...others] : []), place);

/** Adds a part and opens it. */
export function addPart(part: FinishedPart): void {
  const added = { id: randomId(), part, withoutTools: [], withoutCycles: [] };
  editRecord(partRecord, (all) => [added, ...all]);
}

/** Adds an empty part if there is none. That is no step of undo. */
export function openFirstPart(name: string): void {
  if (partRecord.now().length === 0)
    partRecord.put([{ id: randomId(), part: newPart(name), withoutTools: [], withoutCycles: [] }]);
}

/** Opens another part. That is no step of undo. */
export function openPart(id: string): void {
  const all = partRecord.now(),
    wanted = all.find((each) => each.id === id);
  if (wanted) partRecord.put([wanted, ...all.filter((each) => each !== wanted)]);
}

/** Notes the operations of the newest plan of a part by their keys. That is no step of undo. */
export function rememberPlan(id: string, keys: Readonly<Record<Clamping, readonly string[]>>): void {
  const noted = (before: PlanDecisions = NO_DECISIONS, of: readonly string[]) => ({
    ...before,
    keep: of.slice(0, MOST_KEYS),
  });
  partRecord.put(
    partRecord.now().map((each) => {
      if (each.id !== id) return each;
      return { ...each, first: noted(each.first, keys.first), second: noted(each.second, keys.second) };
    }),
  );
}

/** Changes what is set by hand of one clamping of the open part. */
export const editHand = (clamping: Clamping, change: (hand: PlanDecisions["hand"]) => PlanDecisions["hand"]): void =>
  editPart((stored) => {
    const { keep, hand } = stored[clamping] ?? NO_DECISIONS;
    return { ...stored, [clamping]: { keep, hand: change(hand) } };
  });

/** Deletes the open part. */
export const deletePart = (): void => editRecord(partRecord, ([, ...others]) => others);
