import type { HandedResult, TaskResult } from "../../../course/made/result.ts";
import type { RuleName } from "../../../course/judge/judgement.ts";
import { stateOfTask, type TaskState } from "../../../course/progress.ts";

/**
 * Result of running a program here; "unknown": this device does not have its task, "predicted": the task has no program,
 * "stopped": the run did not finish.
 */
export type RerunOutcome = "passes" | "fails" | "unknown" | "predicted" | "none" | "stopped";

/** What an answer misses: a rule of the task, or the right answers to its questions. */
export type MissedGoal = RuleName | "answers";
/** A result judged again here. */
export interface Rerun {
  readonly is: RerunOutcome;
  readonly missed: readonly MissedGoal[];
}

/** Results of one learner; without a file name if they came by a link. */
export interface LearnerFile {
  readonly file: string;
  readonly result: HandedResult;
}

/** One task of one learner, from one file. */
export interface ResultRow {
  readonly key: string;
  /** As typed; empty where none was. */
  readonly name: string;
  /** The same for all results of a learner. */
  readonly learner: string;
  /** The class, as typed; empty where none was. */
  readonly group: string;
  /** The set that it was handed in with. */
  readonly set: HandedResult["set"];
  /** It was handed in after the set was due; time ran out in its exam. */
  readonly late: boolean;
  readonly timeOut: boolean;
  /** When it was handed in, ms since 1970. */
  readonly made: number;
  /** The same learner handed in the same task again later, and that result counts. */
  readonly earlier: boolean;
  readonly state: TaskState;
  readonly result: TaskResult;
}

/** A name with one blank between its words. */
export const plainName = (name: string): string => name.trim().replace(/\s+/g, " ");

/** Key of a learner, ignoring case and extra blanks; each result without a name counts as another learner. */
const learnerOf = (name: string, index: number): string => {
  const plain = plainName(name).normalize("NFKC").toLowerCase();
  return plain === "" ? `#${index}` : `=${plain}`;
};

/** Number of learners. */
export const learnerCount = (all: readonly LearnerFile[]): number =>
  new Set(all.map(({ result }, i) => learnerOf(result.name, i))).size;

/** An exam that the due moment ends is handed in a little later, ms. */
const DUE = 60_000;

/** Rows in order of arrival. If a task was handed in repeatedly the newest counts, or the last of equal age. */
export function resultRows(all: readonly LearnerFile[]): readonly ResultRow[] {
  const rows = all.flatMap(({ result: { name, group = "", made, set, exam, tasks } }, i) =>
    tasks.map((result) => ({
      who: `${learnerOf(name, i)} ${result.id}`,
      key: `${i} ${result.id}`,
      name: plainName(name),
      learner: learnerOf(name, i),
      group: plainName(group),
      set,
      late: set?.due !== undefined && made > set.due + DUE,
      timeOut: exam?.by === "time",
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

/** True if these results are already in the list. */
export const hasResult = (all: readonly LearnerFile[], one: HandedResult): boolean =>
  all.some(({ result }) => JSON.stringify(result) === JSON.stringify(one));

/** Sortable columns, in the order of the table. */
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

/** Columns of numbers, aligned right. */
export const NUMBERS: readonly ResultColumn[] = ["tries", "hints", "time", "steps", "machining", "score"];

const STATES: readonly TaskState[] = ["alone", "hints", "solution", "tried", "new"];
const RERUN_ORDER: readonly RerunOutcome[] = ["passes", "fails", "predicted", "none", "unknown", "stopped"];

type Sorted = string | number;

/** Sort value of a row; missing values come last. */
function sortedBy(
  { name, made, state, result }: ResultRow,
  column: ResultColumn,
  again: RerunOutcome | undefined,
): Sorted {
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
      return again ? RERUN_ORDER.indexOf(again) : RERUN_ORDER.length;
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

/** Sort options: the rerun result of each row, and the text order of the language. */
export interface SortOptions {
  readonly again: ReadonlyMap<string, RerunOutcome>;
  readonly compare: (a: string, b: string) => number;
}

/** Rows sorted by a column; equal rows keep their order. `down`: descending. */
export function sortedRows(
  rows: readonly ResultRow[],
  column: ResultColumn | null,
  down: boolean,
  { again, compare }: SortOptions,
): readonly ResultRow[] {
  if (!column) return rows;
  const value = (row: ResultRow) => sortedBy(row, column, again.get(row.key));
  const by = (a: Sorted, b: Sorted): number =>
    typeof a === "string" && typeof b === "string" ? compare(a, b) : Number(a > b) - Number(a < b);
  return rows.toSorted((a, b) => (down ? by(value(b), value(a)) : by(value(a), value(b))));
}
