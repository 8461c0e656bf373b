import type { UnreadRow } from "../../program/files/bounded.ts";
import { mergedExams } from "../../course/exam.ts";
import { mergedProgress } from "../../course/progress.ts";
import { readOwn, type OwnEntry } from "../../program/edits/own-cycle.ts";
import { mergedLibrary, writeLibrary } from "../../program/edits/own-library.ts";
import { mergedTools } from "../../program/tools/tool-list.ts";
import { writeTableJson } from "../../program/tools/tool-table-json.ts";
import type { KeptRecord } from "../base/record.ts";
import { isSameData } from "../base/same.ts";
import { readSettings, useSettings, type Settings } from "../base/settings/settings.ts";
import { editRecord } from "../document/edit-record.ts";
import { editSettings } from "../document/edit-settings.ts";
import { ownRecord } from "../document/own-store.ts";
import { mergedSheets, sheetRecord } from "../document/sheet-columns.ts";
import { toolRecord, toolsOnDevice } from "../document/tool-store.ts";
import { mergedResults, resultRecord } from "./course/collected-results.ts";
import { examRecord } from "./course/exams.ts";
import { formRecord, mergedForms } from "./course/kept-form.ts";
import { progressRecord } from "./course/progress.ts";
import { mergedSets, setRecord } from "./course/saved-sets.ts";
import { mergedTasks, taskRecord } from "./course/saved-tasks.ts";
import { mergedParts, partRecord } from "./part-store.ts";
import { countWork, mergedWorked, workedRecord } from "./course/working-time.ts";

/** Tables offered for restoring: keep mine, add what is missing, or replace. Each is one part. */
export const TABLES = ["tools", "own", "parts"] as const;
/** Checkboxes offered for restoring, and their default. Better data of this device stay. */
export const BOXES = { course: true, settings: false } as const;
export type Group = (typeof TABLES)[number] | keyof typeof BOXES;

/** A part of an archive besides the works. */
export interface Part<T> {
  /** Group in which it is offered. */
  readonly group: Group;
  /** The value of this device. */
  current(): T;
  /** Data to archive; `read` gets data that anybody may have written, and returns null if they are damaged. */
  write(value: T): object;
  read(raw: unknown): T | null;
  /** The rows that `read` leaves out. */
  unread?(raw: unknown): readonly UnreadRow[];
  /** True if there is nothing to archive. */
  isEmpty(value: T): boolean;
  isSame(one: T, other: T): boolean;
  /** Merges restored data into mine. `nameHere`: name here of a work that had another name there. */
  merge(mine: T, brought: T, nameHere: ReadonlyMap<string, string>): T;
  /** Applies a value. */
  apply(value: T): void | Promise<void>;
  /** Copies for people and other programs: texts by path. */
  files?(value: T): Readonly<Record<string, string>>;
}

/** A record as a part; restoring it is one step of undo. */
const ofRecord = <T>(record: KeptRecord<T>, more: Pick<Part<T>, "group" | "merge"> & Partial<Part<T>>): Part<T> => ({
  current: record.now,
  write: record.write,
  read: record.read,
  unread: record.unread,
  isEmpty: (value) => record.isSame(value, record.first),
  isSame: record.isSame,
  apply: (value) => editRecord(record, () => value),
  ...more,
});

const ownNumber = (entry: OwnEntry) => readOwn(entry).number ?? entry.number.trim();

/** Settings are no record: each change is saved at once, and other tabs keep theirs. */
const settingsPart: Part<Settings> = {
  group: "settings",
  current: useSettings.getState,
  write: (settings) => settings,
  read: readSettings,
  isEmpty: () => false,
  isSame: isSameData,
  // A backup without its own cutting data or machine leaves the local ones.
  merge: (mine, brought) => ({
    ...brought,
    cutting: brought.cutting || mine.cutting,
    machine: brought.machine || mine.machine,
  }),
  apply: (settings) => editSettings(settings),
  files: (settings) => ({
    ...(settings.cutting !== "" && { "tools/CUTTING.json": settings.cutting }),
    ...(settings.machine !== "" && { "tools/MACHINE.json": settings.machine }),
    "settings.json": JSON.stringify(settings, null, 2),
  }),
};

/** All parts of an archive besides the works, in the order in which they are restored. */
const parts = {
  tools: ofRecord(toolRecord, {
    group: "tools",
    isEmpty: () => false,
    merge(mine, brought) {
      const [theirs, ours] = [toolsOnDevice(brought).rows, toolsOnDevice(mine).rows];
      const taken = new Set(mine.map(({ id }) => ours.get(id)?.number ?? null));
      const missing = brought.filter(({ id }) => !taken.has(theirs.get(id)?.number ?? null));
      return mergedTools(
        mine,
        missing.map(({ cells }) => cells),
      ).list;
    },
    files(list) {
      const { table, mills } = toolsOnDevice(list);
      return { "tools/TOOLS.json": writeTableJson(table.tools, mills) };
    },
  }),
  own: ofRecord(ownRecord, {
    group: "own",
    merge(mine, brought) {
      const taken = new Set(mine.map(ownNumber));
      return mergedLibrary(
        mine,
        brought.filter((entry) => !taken.has(ownNumber(entry))),
      ).list;
    },
    files: (list) => ({ "tools/CYCLES.json": writeLibrary(list) }),
  }),
  parts: ofRecord(partRecord, { group: "parts", merge: mergedParts }),
  course: ofRecord(progressRecord, { group: "course", merge: mergedProgress }),
  taught: ofRecord(taskRecord, { group: "course", merge: mergedTasks }),
  sets: ofRecord(setRecord, { group: "course", merge: mergedSets }),
  exams: ofRecord(examRecord, { group: "course", merge: mergedExams }),
  forms: ofRecord(formRecord, { group: "course", merge: mergedForms }),
  worked: ofRecord(workedRecord, {
    group: "course",
    current() {
      countWork();
      return workedRecord.now();
    },
    merge: mergedWorked,
  }),
  results: ofRecord(resultRecord, { group: "course", merge: mergedResults }),
  settings: settingsPart,
  // Columns that were assigned on this device stay as they are.
  columns: ofRecord(sheetRecord, { group: "settings", merge: (mine, brought) => mergedSheets(brought, mine) }),
} as const;

export type PartName = keyof typeof parts;
type ValueOf<P> = P extends Part<infer T> ? T : never;
/** The values of all parts; null for missing ones. */
export type PartValues = { readonly [P in PartName]: ValueOf<(typeof parts)[P]> | null };

export const PARTS: Readonly<Record<PartName, Part<unknown>>> = parts;
export const PART_NAMES = Object.keys(parts) as readonly PartName[];

/** A value for each part. */
export const eachPart = (valueOf: (part: Part<unknown>, name: PartName) => unknown): PartValues =>
  Object.fromEntries(PART_NAMES.map((name) => [name, valueOf(PARTS[name], name)])) as PartValues;
