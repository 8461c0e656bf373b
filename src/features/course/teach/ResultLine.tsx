import { Icon } from "../../../app/base/Icon.tsx";
import { NUMBERS, type ResultColumn, type ResultRow } from "../../../app/records/course/result-rows.ts";
import { openSubmission } from "./submission.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** One task of one learner, with a button for its program. `waits`: its run is pending. */
export function ResultLine({
  row: { result, earlier },
  columns,
  text,
  waits,
}: {
  readonly row: ResultRow;
  readonly columns: readonly ResultColumn[];
  readonly text: Readonly<Record<ResultColumn, string>>;
  readonly waits: boolean;
}) {
  const { results: words } = useTexts("course-teach"),
    { table } = useTexts("course-set");
  const { program } = result;
  const cell = (column: ResultColumn) =>
    column === "made" && earlier ? `${text.made} · ${words.earlier}` : text[column];
  return (
    <tr className={earlier ? "taught-earlier" : undefined}>
      {columns.map((column) =>
        column === "task" ? (
          <th key={column} scope="row">
            {text.task}
          </th>
        ) : (
          <td
            key={column}
            className={NUMBERS.includes(column) ? "number" : `taught-${column}`}
            role={column === "again" && waits ? "status" : undefined}
          >
            {cell(column)}
          </td>
        ),
      )}
      <td className="taught-open">
        {program !== null && (
          <button
            type="button"
            className="button"
            aria-label={words.open(result.title)}
            onClick={() => openSubmission(program, table.whose(text.task, text.name, text.again), result.id)}
          >
            <Icon name="fold" />
          </button>
        )}
      </td>
    </tr>
  );
}
