import type { MissedGoal, Rerun, ResultRow } from "./result-rows.ts";

/** Outcomes of a cell, best first; "passed" where the learner's device does not know how, "pending" while it runs. */
export const CELL_STATES = ["alone", "hints", "solution", "passed", "failed", "tried", "new", "pending"] as const;
export type CellState = (typeof CELL_STATES)[number];

/** One task of one learner: its newest result. */
export interface ClassCell {
  readonly row: ResultRow;
  readonly state: CellState;
  readonly missed: readonly MissedGoal[];
}
/** A learner with the cells of the tasks, undefined where nothing was handed in. */
export interface ClassLearner {
  readonly key: string;
  readonly name: string;
  readonly group: string;
  readonly late: boolean;
  readonly timeOut: boolean;
  readonly cells: readonly (ClassCell | undefined)[];
  readonly passed: number;
}
/** A task, how many learners passed it of those who handed it in, and the goal that the others miss most. */
export interface ClassTask {
  readonly id: string;
  readonly title: string;
  readonly passed: number;
  readonly of: number;
  readonly mostMissed: { readonly goal: MissedGoal; readonly learners: number } | null;
}
export interface ClassTable {
  readonly tasks: readonly ClassTask[];
  readonly learners: readonly ClassLearner[];
}

const PASSED: readonly CellState[] = ["alone", "hints", "solution", "passed"];
export const isPassedCell = (cell: ClassCell | undefined): boolean => cell !== undefined && PASSED.includes(cell.state);

/** The state of a result: the run here decides, and the learner's device knows the help that was used. */
function stateOfCell(row: ResultRow, again: Rerun | undefined): CellState {
  const { state } = row;
  const isReported = state !== "new" && state !== "tried";
  switch (again?.is) {
    case undefined:
      return "pending";
    case "passes":
      return isReported ? state : "passed";
    case "fails":
      return "failed";
    case "none":
      return state === "new" ? "new" : "tried";
    default:
      return state;
  }
}

function mostMissed(cells: readonly (ClassCell | undefined)[]): ClassTask["mostMissed"] {
  const counts = new Map<MissedGoal, number>();
  for (const goal of cells.flatMap((cell) => cell?.missed ?? [])) counts.set(goal, (counts.get(goal) ?? 0) + 1);
  const [first] = [...counts].toSorted(([, a], [, b]) => b - a);
  return first ? { goal: first[0], learners: first[1] } : null;
}

/** The newest results as a table of learners and tasks, in order of arrival. */
export function classTable(rows: readonly ResultRow[], reruns: ReadonlyMap<string, Rerun>): ClassTable {
  const counted = rows.filter(({ earlier }) => !earlier);
  const titles = new Map(counted.map(({ result }) => [result.id, result.title]));
  const ids = [...new Set(counted.map(({ result }) => result.id))];
  const learners = [...new Set(counted.map(({ learner }) => learner))].map((key): ClassLearner => {
    const own = counted.filter(({ learner }) => learner === key);
    const cells = ids.map((id): ClassCell | undefined => {
      const row = own.find(({ result }) => result.id === id);
      const again = row && reruns.get(row.key);
      return row && { row, state: stateOfCell(row, again), missed: again?.missed ?? [] };
    });
    return {
      key,
      name: own[0]?.name ?? "",
      group: own.findLast(({ group }) => group !== "")?.group ?? "",
      late: own.some(({ late }) => late),
      timeOut: own.some(({ timeOut }) => timeOut),
      cells,
      passed: cells.filter(isPassedCell).length,
    };
  });
  const tasks = ids.map((id, i): ClassTask => {
    const cells = learners.map(({ cells: all }) => all[i]);
    return {
      id,
      title: titles.get(id) ?? id,
      passed: cells.filter(isPassedCell).length,
      of: cells.filter((cell) => cell !== undefined).length,
      mostMissed: mostMissed(cells),
    };
  });
  return { tasks, learners };
}

/** Learners by name, by class, by the tasks passed, or by the state in one task (its index). */
export type ClassSort = "name" | "group" | "passed" | number;

/** Learners sorted; equal ones keep their order. Those who did not hand in a task come last. */
export function sortedLearners(
  learners: readonly ClassLearner[],
  by: ClassSort,
  down: boolean,
  compare: (a: string, b: string) => number,
): readonly ClassLearner[] {
  const rank = ({ cells }: ClassLearner, task: number) => {
    const cell = cells[task];
    return cell ? CELL_STATES.indexOf(cell.state) : CELL_STATES.length;
  };
  const order = (a: ClassLearner, b: ClassLearner): number => {
    if (by === "name" || by === "group") return compare(a[by], b[by]);
    return by === "passed" ? a.passed - b.passed : rank(a, by) - rank(b, by);
  };
  return learners.toSorted((a, b) => (down ? order(b, a) : order(a, b)));
}

/** Which rows a class table has. An empty text or set: all. */
export interface ClassFilter {
  readonly group: string;
  readonly set: string;
  readonly name: string;
}
const folded = (text: string): string => text.normalize("NFKC").toLowerCase();

export const filteredRows = (rows: readonly ResultRow[], { group, set, name }: ClassFilter): readonly ResultRow[] =>
  rows.filter(
    (row) =>
      (group === "" || folded(row.group) === folded(group)) &&
      (set === "" || row.set?.id === set) &&
      folded(row.name).includes(folded(name.trim())),
  );
