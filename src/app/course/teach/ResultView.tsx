import { useEffect, useMemo, useRef, useState } from "react";
import { decimalSign, formatNumber } from "../../../i18n/number.ts";
import { downloadText } from "../../files/download.ts";
import { Icon } from "../../Icon.tsx";
import { useSettings } from "../../settings/settings.ts";
import { useModal } from "../../use-modal.ts";
import { taskOfId, verdictHere } from "./hand-in.ts";
import { addResults } from "./open-taught.ts";
import { RESULT_COLUMNS, resultsCsv, resultRows, sortedRows, type Again, type ResultColumn, type ResultRow } from "./result-rows.ts";
import { ResultLine } from "./ResultLine.tsx";
import { leaveTaught, type ShownResults } from "./taught-shown.ts";
import { useTeachTexts } from "./use-teach-texts.ts";

async function runAgain({ id, program }: ResultRow["result"]): Promise<Again> {
  const task = await taskOfId(id);
  if (task?.kind === "predict") return "foretold";
  if (program === null) return "none";
  if (!task) return "unknown";
  return verdictHere(task, program).passed ? "passes" : "fails";
}

/** What was found of results that were run here: those that come later do not run the others again. */
const found = new WeakMap<ResultRow["result"], Again>();

/** Runs each program once more, one after the other. */
function useAgain(rows: readonly ResultRow[]): ReadonlyMap<string, Again> {
  const [again, say] = useState<ReadonlyMap<string, Again>>(new Map());
  useEffect(() => {
    let gone = false;
    void (async () => {
      const all = new Map<string, Again>();
      for (const { key, result } of rows) {
        const is = found.get(result) ?? await runAgain(result);
        found.set(result, is);
        all.set(key, is);
        if (gone) return;
        say(new Map(all));
        await new Promise((goOn) => setTimeout(goOn));
      }
    })();
    return () => {
      gone = true;
    };
  }, [rows]);
  return again;
}

const MINUTE = 60;

/** What learners handed in, as a table that is sorted, printed and saved as a sheet; each program is run once more and can be opened. */
export function ResultView({ shown: { results, notRead, twice } }: { readonly shown: ShownResults }) {
  const t = useTeachTexts();
  const language = useSettings((s) => s.language);
  const dialog = useRef<HTMLDialogElement>(null), file = useRef<HTMLInputElement>(null);
  useModal(dialog);
  const rows = useMemo(() => resultRows(results), [results]);
  const again = useAgain(rows);
  const [sort, sortBy] = useState<{ readonly column: ResultColumn; readonly down: boolean } | null>(null);
  const words = t.results, [only] = results, isOne = results.length === 1 && only !== undefined;
  const day = (made: number) => new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" }).format(made);
  const title = isOne ? words.title(only.name) : words.gathered(String(results.length));
  const heads: Readonly<Record<ResultColumn, string>> = {
    name: words.name,
    made: words.made,
    task: words.task,
    state: words.state,
    again: words.again,
    tries: words.tries,
    hints: words.hints,
    solution: words.solution,
    time: words.time,
    steps: words.steps,
    machining: words.machining,
    score: words.score,
  };
  const isScored = rows.some(({ result }) => result.score !== null);
  const columns = RESULT_COLUMNS.filter((column) => (column !== "name" && column !== "made" || !isOne) && (column !== "score" || isScored));
  const told: Readonly<Record<Again, string>> = {
    passes: words.againPasses,
    fails: words.againFails,
    unknown: words.unknown,
    foretold: words.foretold,
    none: words.none,
  };
  const sorted = sortedRows(rows, sort?.column ?? null, sort?.down ?? false, {
    again,
    compare: (a, b) => a.localeCompare(b, language, { numeric: true }),
  });
  const number = (value: number) => formatNumber(language, value, 0);
  const text = ({ key, name, made, state, result }: ResultRow): Readonly<Record<ResultColumn, string>> => {
    const is = again.get(key);
    return {
      name: name === "" ? words.noName : name,
      made: day(made),
      task: result.title,
      state: words.states[state],
      again: is ? told[is] : "…",
      tries: number(result.tries),
      hints: number(result.hints),
      solution: result.solution ? words.yes : words.no,
      time: result.worked < MINUTE ? words.seconds(number(result.worked)) : words.minutes(number(result.worked / MINUTE)),
      steps: number(result.steps),
      machining: result.seconds === null ? "–" : words.seconds(number(result.seconds)),
      score: result.score === null ? "–" : number(result.score),
    };
  };
  const save = () => {
    const cells = (row: ResultRow): readonly (string | number | null)[] => {
      const { result } = row, written = text(row);
      const plain: Partial<Record<ResultColumn, number | null>> = {
        tries: result.tries,
        hints: result.hints,
        time: Math.round(result.worked),
        steps: result.steps,
        machining: result.seconds,
        score: result.score,
      };
      return RESULT_COLUMNS.map((column) => {
        const value = plain[column];
        return column === "name" ? row.name : value === undefined ? written[column] : value;
      });
    };
    const unit: Partial<Record<ResultColumn, string>> = { time: " (s)", machining: " (s)" };
    const head = RESULT_COLUMNS.map((column) => `${heads[column]}${unit[column] ?? ""}`);
    downloadText(resultsCsv(head, sorted.map(cells), decimalSign(language)), `${title}.csv`.replace(/[\\/:*?"<>|]+/g, "-"));
  };
  return (
    <dialog ref={dialog} className="handing taught-wide" aria-label={title}
      onClose={(event) => event.target === dialog.current && !dialog.current.open && leaveTaught()}
      onKeyDown={(event) => event.stopPropagation()}
    >
      <div className="handing-head">
        <h2>{title}</h2>
        <button type="button" className="button icon plain" aria-label={t.close} onClick={() => dialog.current?.close()}>
          <Icon name="close" />
        </button>
      </div>
      <p>{isOne ? words.lead(day(only.made)) : words.several}</p>
      <div role="status" className="taught-said">
        {notRead.length > 0 && (
          <p className="field-message warning">
            <Icon name="warning" /> {words.notRead(notRead.join(", "))}
          </p>
        )}
        {twice.some((name) => name !== "") && (
          <p className="field-message info">
            <Icon name="info" /> {words.twice(twice.join(", "))}
          </p>
        )}
      </div>
      {rows.length === 0
        ? (
          <p className="field-message info">
            <Icon name="info" /> {words.empty}
          </p>
        )
        : (
          <div className="taught-table" role="region" aria-label={title} tabIndex={0}>
            <table>
              <thead>
                <tr>
                  {columns.map((column) => (
                    <th key={column} scope="col" aria-sort={sort?.column !== column ? "none" : sort.down ? "descending" : "ascending"}>
                      <button type="button" className="taught-sort" title={words.sort(heads[column])} onClick={() =>
                        sortBy({ column, down: sort?.column === column && !sort.down })}
                      >
                        {heads[column]}
                        {sort?.column === column && <Icon name={sort.down ? "down" : "up"} />}
                      </button>
                    </th>
                  ))}
                  <th scope="col" className="taught-open">{words.program}</th>
                </tr>
              </thead>
              <tbody>
                {sorted.map((row) => <ResultLine key={row.key} row={row} columns={columns} text={text(row)} waits={!again.has(row.key)} />)}
              </tbody>
            </table>
          </div>
        )}
      <div className="handing-ways">
        <button type="button" className="button" onClick={() => file.current?.click()}>
          <Icon name="add" /> {words.add}
        </button>
        <input ref={file} type="file" multiple hidden accept=".json,application/json" aria-label={words.add} onChange={(event) => {
          const chosen = [...event.currentTarget.files ?? []];
          event.currentTarget.value = "";
          if (chosen.length > 0) void addResults(chosen);
        }} />
        {rows.length > 0 && (
          <>
            <button type="button" className="button" onClick={save}>
              <Icon name="download" /> {words.csv}
            </button>
            <button type="button" className="button" onClick={() => print()}>
              <Icon name="print" /> {words.print}
            </button>
          </>
        )}
      </div>
    </dialog>
  );
}
