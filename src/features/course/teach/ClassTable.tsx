import { Fragment, useMemo, useState, type CSSProperties } from "react";
import { decimalSign } from "../../../i18n/number.ts";
import { downloadText } from "../../../app/base/download.ts";
import { csvFormat, writeCsv } from "../../../program/files/csv.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import {
  classTable,
  filteredRows,
  sortedLearners,
  type CellState,
  type ClassCell,
  type ClassFilter,
  type ClassLearner,
  type ClassSort,
} from "../../../app/records/course/class-table.ts";
import type { MissedGoal, Rerun, ResultRow } from "../../../app/records/course/result-rows.ts";
import { openSubmission } from "./submission.ts";

/** Goals named in a cell; the table has no room for more. */
const NAMED = 2;
const ALL: ClassFilter = { group: "", set: "", name: "" };

/** What cells say: the state, and the goals that are missed. */
function useCellWords() {
  const { judged } = useTexts("course-teach"),
    { table: words } = useTexts("course-set");
  const goal = (missed: MissedGoal): string => (missed === "answers" ? words.answers : judged[missed]);
  const text = ({ state, missed }: ClassCell): string => {
    if (state !== "failed" || missed.length === 0) return words.states[state];
    const more = missed.length > NAMED ? " …" : "";
    return `${words.states.failed}: ${missed.slice(0, NAMED).map(goal).join(", ")}${more}`;
  };
  return { goal, text };
}

const MARKS: Readonly<Record<CellState, string>> = {
  alone: "✓",
  hints: "✓",
  solution: "✓",
  passed: "✓",
  failed: "✗",
  tried: "…",
  new: "–",
  pending: "…",
};

/** A cell in colour and words; its button opens the program. */
function Cell({ cell, task, learner }: { readonly cell: ClassCell; readonly task: string; readonly learner: string }) {
  const { table: words } = useTexts("course-set");
  const { text } = useCellWords();
  const { program, id } = cell.row.result;
  const said = (
    <>
      <span aria-hidden="true">{MARKS[cell.state]}</span> {text(cell)}
    </>
  );
  if (program === null) return <span className="class-said">{said}</span>;
  return (
    <button
      type="button"
      className="class-said"
      aria-label={words.open(task, learner, text(cell))}
      onClick={() => openSubmission(program, words.whose(task, learner, text(cell)), id)}
    >
      {said}
    </button>
  );
}

/** Filters by set, class and name; those with nothing to choose are left out. */
function Filters({
  rows,
  filter,
  change,
}: {
  readonly rows: readonly ResultRow[];
  readonly filter: ClassFilter;
  readonly change: (some: Partial<ClassFilter>) => void;
}) {
  const { table: words } = useTexts("course-set");
  const groups = [...new Map(rows.map(({ group }) => [group.toLowerCase(), group])).values()]
    .filter((group) => group !== "")
    .toSorted();
  const sets = [...new Map(rows.flatMap(({ set }) => (set ? [[set.id, set.title] as const] : [])))];
  const menu = (label: string, all: string, value: string, options: readonly (readonly [string, string])[]) => (
    <label>
      <span className="unseen">{label}</span>
      <select
        className="select"
        aria-label={label}
        value={value}
        onChange={(event) => change({ [label === words.set ? "set" : "group"]: event.currentTarget.value })}
      >
        <option value="">{all}</option>
        {options.map(([key, name]) => (
          <option key={key} value={key}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
  return (
    <div className="class-filters" role="group" aria-label={words.filter}>
      {sets.length > 0 && menu(words.set, words.allSets, filter.set, sets)}
      {groups.length > 0 &&
        menu(
          words.group,
          words.allGroups,
          filter.group,
          groups.map((each) => [each, each] as const),
        )}
      <input
        type="search"
        className="input"
        aria-label={words.findName}
        placeholder={words.findName}
        value={filter.name}
        onChange={(event) => change({ name: event.currentTarget.value })}
      />
    </div>
  );
}

interface Props {
  readonly title: string;
  readonly rows: readonly ResultRow[];
  readonly reruns: ReadonlyMap<string, Rerun>;
}

/** Learners and tasks as a table: who passed what, and what is missed most; filtered, sorted, saved as CSV. */
export function ClassTable({ title, rows, reruns }: Props) {
  const { table: words } = useTexts("course-set"),
    teach = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const { goal, text } = useCellWords();
  const [filter, setFilter] = useState(ALL);
  const [sort, setSort] = useState<{ readonly by: ClassSort; readonly down: boolean } | null>(null);
  const { tasks, learners } = useMemo(() => classTable(filteredRows(rows, filter), reruns), [rows, filter, reruns]);
  const compare = (a: string, b: string) => a.localeCompare(b, language, { numeric: true });
  const shown = sort ? sortedLearners(learners, sort.by, sort.down, compare) : learners;
  const hasGroups = learners.some(({ group }) => group !== "");
  const nameOf = ({ name }: ClassLearner) => (name === "" ? teach.results.noName : name);
  const score = ({ passed, cells }: ClassLearner) => words.passedOf(String(passed), String(cells.length));
  const head = (by: ClassSort, name: string, more: string | null = null) => (
    <th scope="col" aria-sort={sort?.by !== by ? "none" : sort.down ? "descending" : "ascending"}>
      <button
        type="button"
        className="taught-sort"
        title={teach.results.sort(name)}
        onClick={() => setSort({ by, down: sort?.by === by && !sort.down })}
      >
        <span>{name}</span>
        {sort?.by === by && <Icon name={sort.down ? "down" : "up"} />}
      </button>
      {more !== null && <span className="class-sum">{more}</span>}
    </th>
  );
  const missed = (task: (typeof tasks)[number]) =>
    [
      words.passedOf(String(task.passed), String(task.of)),
      ...(task.mostMissed ? [words.mostMissed(goal(task.mostMissed.goal), String(task.mostMissed.learners))] : []),
    ].join("; ");
  const save = () => {
    const csv = writeCsv(
      [
        [words.name, words.group, ...tasks.map((task) => task.title), words.passed, words.notes],
        ...shown.map((each) => [
          each.name,
          each.group,
          ...each.cells.map((cell) => (cell ? text(cell) : null)),
          each.passed,
          [...(each.late ? [words.late] : []), ...(each.timeOut ? [words.timeOut] : [])].join(", "),
        ]),
        [words.all, null, ...tasks.map(missed), null, null],
      ],
      csvFormat(decimalSign(language)),
    );
    downloadText(csv, `${title}.csv`);
  };
  return (
    <>
      <Filters rows={rows} filter={filter} change={(some) => setFilter({ ...filter, ...some })} />
      {shown.length === 0 ? (
        <Message tone="info">{words.nobody}</Message>
      ) : (
        <div className="taught-table class-table" role="region" aria-label={title} tabIndex={0}>
          <table style={{ "--tasks": tasks.length } as CSSProperties}>
            <thead>
              <tr>
                {head("name", words.name)}
                {hasGroups && head("group", words.group)}
                {tasks.map((task, i) => (
                  <Fragment key={task.id}>{head(i, task.title, missed(task))}</Fragment>
                ))}
                {head("passed", words.passed)}
              </tr>
            </thead>
            <tbody>
              {shown.map((learner) => (
                <tr key={learner.key}>
                  <th scope="row">
                    {nameOf(learner)}
                    {learner.late && <span className="class-note">{words.late}</span>}
                    {learner.timeOut && <span className="class-note">{words.timeOut}</span>}
                  </th>
                  {hasGroups && <td>{learner.group}</td>}
                  {learner.cells.map((cell, i) => (
                    <td key={tasks[i]?.id} className="class-cell" data-state={cell?.state ?? "none"}>
                      {cell ? (
                        <Cell cell={cell} task={tasks[i]?.title ?? ""} learner={nameOf(learner)} />
                      ) : (
                        <span className="unseen">{words.notHandedIn}</span>
                      )}
                    </td>
                  ))}
                  <td className="number">{score(learner)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      <div className="modal-ways taught-ways">
        <button type="button" className="button" onClick={save}>
          <Icon name="download" /> {teach.results.csv}
        </button>
      </div>
    </>
  );
}
