import type { HandedResult, TaskResult } from "../../../course/made/result.ts";
import { stateOfTask, type TaskState } from "../../../course/progress.ts";

/**
 * What a program comes to when it is run here; "unknown" where this device does not have its task, "foretold" where a
 * task has none, "stopped" where the run came to no end.
 */
export type Again = "passes" | "fails" | "unknown" | "foretold" | "none" | "stopped";

/** Results of one learner as they came; without a file's name where they came by a link. */
export interface LearnerFile {
  readonly file: string;
  readonly result: HandedResult;
}

/** One task of one learner, as one file has it. */
export interface ResultRow {
  readonly key: string;
  /** As typed; empty where none was. */
  readonly name: string;
  /** When it was handed in, ms since 1970. */
  readonly made: number;
  /** The same learner handed in the same task later: that one counts. */
  readonly earlier: boolean;
  readonly state: TaskState;
  readonly result: TaskResult;
}

/** A name with one blank between its words. */
export const plainName = (name: string): string => name.trim().replace(/\s+/g, " ");

/**
 * Who handed something in, whatever the case of the name and the blanks in it; who typed no name is somebody of their
 * own each time.
 */
const learnerOf = (name: string, index: number): string => {
  const plain = plainName(name).normalize("NFKC").toLowerCase();
  return plain === "" ? `#${index}` : `=${plain}`;
};

/** How many learners there are. */
export const learnerCount = (all: readonly LearnerFile[]): number =>
  new Set(all.map(({ result }, i) => learnerOf(result.name, i))).size;

/**
 * Rows in the order in which the files came. Of a task that was handed in more than once the newest counts, of one age
 * the last.
 */
export function resultRows(all: readonly LearnerFile[]): readonly ResultRow[] {
  const rows = all.flatMap(({ result: { name, made, tasks } }, i) =>
    tasks.map((result) => ({
      who: `${learnerOf(name, i)} ${result.id}`,
      key: `${i} ${result.id}`,
      name: plainName(name),
      made,
      result,
    })),
  );
  const newest = new Map<string, (typeof rows)[number]>();
  for (const row of rows) if (!((newest.get(row.who)?.made ?? -Infinity) > row.made)) newest.set(row.who, row);
  return rows.map(({ who, ...row }) => ({
    ...row,
    earlier: newest.get(who)?.key !== row.key,
    state: stateOfTask(row.result),
  }));
}

/** Whether a file of results is among those that are there. */
export const isAmong = (all: readonly LearnerFile[], one: HandedResult): boolean =>
  all.some(({ result }) => JSON.stringify(result) === JSON.stringify(one));

/** Columns that rows can be sorted by, as they stand in the table. */
export const RESULT_COLUMNS = [
  "name",
  "made",
  "task",
  "state",
  "again",
  "tries",
  "hints",
  "solution",
  "time",
  "steps",
  "machining",
  "score",
] as const;
export type ResultColumn = (typeof RESULT_COLUMNS)[number];

/** Columns of numbers, which are written to the right. */
export const NUMBERS: readonly ResultColumn[] = ["tries", "hints", "time", "steps", "machining", "score"];

const STATES: readonly TaskState[] = ["alone", "hints", "solution", "tried", "new"];
const AGAIN: readonly Again[] = ["passes", "fails", "foretold", "none", "unknown", "stopped"];

type Sorted = string | number;

/** What a row is sorted by; what is missing comes last. */
function sortedBy({ name, made, state, result }: ResultRow, column: ResultColumn, again: Again | undefined): Sorted {
  switch (column) {
    case "name":
      return name;
    case "made":
      return made;
    case "task":
      return result.title;
    case "state":
      return STATES.indexOf(state);
    case "again":
      return again ? AGAIN.indexOf(again) : AGAIN.length;
    case "tries":
      return result.tries;
    case "hints":
      return result.hints;
    case "solution":
      return Number(result.solution);
    case "time":
      return result.worked;
    case "steps":
      return result.steps;
    case "machining":
      return result.seconds ?? Infinity;
    case "score":
      return result.score ?? -Infinity;
  }
}

/** How rows are put in order: what came of running each of them here, and how texts of the language compare. */
export interface SortedHow {
  readonly again: ReadonlyMap<string, Again>;
  readonly compare: (a: string, b: string) => number;
}

/** Rows in the order of a column; rows that are the same there keep their order. `down`: the greatest first. */
export function sortedRows(
  rows: readonly ResultRow[],
  column: ResultColumn | null,
  down: boolean,
  { again, compare }: SortedHow,
): readonly ResultRow[] {
  if (!column) return rows;
  const value = (row: ResultRow) => sortedBy(row, column, again.get(row.key));
  const by = (a: Sorted, b: Sorted): number =>
    typeof a === "string" && typeof b === "string" ? compare(a, b) : Number(a > b) - Number(a < b);
  return rows.toSorted((a, b) => (down ? by(value(b), value(a)) : by(value(a), value(b))));
}

/** Marks a file as UTF-8 for spreadsheets. */
const BOM = "\uFEFF";

/** How the cells of a sheet are written. */
interface SheetHow {
  readonly separator: string;
  readonly decimal: string;
}

/**
 * One cell of a sheet. A text that a spreadsheet would run as a formula gets an apostrophe in front, which shows that
 * it is text; numbers stay numbers.
 */
export function sheetCell(value: string | number | null, { separator, decimal }: SheetHow): string {
  if (value === null) return "";
  if (typeof value === "number") return String(value).replace(".", decimal);
  const plain = value.replace(/[\r\n\t]+/g, " ");
  const safe = /^\s*[=+\-@|%＝＋－＠]/.test(plain) ? `'${plain}` : plain;
  return safe.includes(separator) || /["]|^\s|\s$/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

/**
 * A table as a sheet. `decimal`: that of the language; with a comma the cells are parted by semicolons, as its
 * spreadsheets expect.
 */
export function resultsCsv(
  head: readonly string[],
  rows: readonly (readonly (string | number | null)[])[],
  decimal: string,
): string {
  const how = { separator: decimal === "," ? ";" : ",", decimal };
  const lines = [head, ...rows].map((cells) => cells.map((cell) => sheetCell(cell, how)).join(how.separator));
  return BOM + lines.map((line) => `${line}\r\n`).join("");
}
