import { RowGuard } from "../../../app/base/RowGuard.tsx";
import { Icon } from "../../../app/base/Icon.tsx";
import { NUMBERS, type ResultColumn, type ResultRow } from "../../../app/records/course/result-rows.ts";
import { ResultLine } from "./ResultLine.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** The column that sorts the table. `down`: the greatest first. */
export interface ResultSort {
  readonly column: ResultColumn;
  readonly down: boolean;
}

interface TableProps {
  readonly title: string;
  readonly rows: readonly ResultRow[];
  readonly columns: readonly ResultColumn[];
  readonly heads: Readonly<Record<ResultColumn, string>>;
  readonly text: (row: ResultRow) => Readonly<Record<ResultColumn, string>>;
  readonly waits: (key: string) => boolean;
  readonly sort: ResultSort | null;
  readonly sortBy: (sort: ResultSort) => void;
}

/** Results as a table; its first column stays visible if the table is wider than the screen. */
export function ResultTable({ title, rows, columns, heads, text, waits, sort, sortBy }: TableProps) {
  const { results: words } = useTexts("course-teach");
  return (
    <div className="taught-table" role="region" aria-label={title} tabIndex={0}>
      <table>
        <thead>
          <tr>
            {columns.map((column) => (
              <th
                key={column}
                scope="col"
                className={NUMBERS.includes(column) ? "number" : undefined}
                aria-sort={sort?.column !== column ? "none" : sort.down ? "descending" : "ascending"}
              >
                <button
                  type="button"
                  className="taught-sort"
                  title={words.sort(heads[column])}
                  onClick={() => sortBy({ column, down: sort?.column === column && !sort.down })}
                >
                  <span>{heads[column]}</span>
                  {sort?.column === column && <Icon name={sort.down ? "down" : "up"} />}
                </button>
              </th>
            ))}
            <th scope="col" className="taught-open">
              {words.program}
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <RowGuard key={row.key} name={row.name} columns={columns.length + 1}>
              <ResultLine row={row} columns={columns} text={text(row)} waits={waits(row.key)} />
            </RowGuard>
          ))}
        </tbody>
      </table>
    </div>
  );
}
