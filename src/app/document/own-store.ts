import { z } from "zod/mini";
import type { OwnList } from "../../program/edits/own-library.ts";
import { notice } from "../base/notices.ts";
import { record } from "../base/record.ts";
import { uniqueIds } from "../base/unique.ts";
import { editRecord } from "./edit-record.ts";
import { forget } from "./steps.ts";

const text = z.string().check(z.maxLength(500));
const parameter = z.object({
  id: text,
  q: text,
  prompt: text,
  kind: z.enum(["length", "angle", "feed", "choice", "number"]),
  min: text,
  max: text,
  first: text,
  choices: text,
});
const cycle = z.object({ id: text, number: text, name: text, parameters: z.array(parameter).check(uniqueIds) });

const NONE: OwnList = [];

/** The own cycles of this device, as typed. They belong to no program: any program may call one. */
export const ownRecord = record({
  key: "own-cycles",
  version: 1,
  schema: z.object({ cycles: z.array(cycle).check(uniqueIds) }),
  rows: { of: "cycles", each: cycle },
  from: ({ cycles }): OwnList => cycles,
  to: (cycles) => ({ cycles }),
  first: NONE,
  undo: forget,
  say: (trouble) => notice(trouble === "damaged" ? "ownDamaged" : "ownNotKept"),
});
export const useOwn = ownRecord.use;

/** Changes the list as one step of undo; successive changes at the same place are one step. */
export const editOwn = (change: (list: OwnList) => OwnList, place: string | null = null): void =>
  editRecord(ownRecord, change, place);
