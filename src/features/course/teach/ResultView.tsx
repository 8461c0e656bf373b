import { useMemo, useRef, useState } from "react";
import { decimalSign } from "../../../i18n/number.ts";
import { downloadText } from "../../../app/base/download.ts";
import { csvFormat, writeCsv } from "../../../program/files/csv.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useCollectedResults } from "../../../app/records/course/collected-results.ts";
import { addResults } from "./open-taught.ts";
import {
  learnerCount,
  plainName,
  RESULT_COLUMNS,
  resultRows,
  sortedRows,
  type ResultColumn,
} from "../../../app/records/course/result-rows.ts";
import { ClassTable } from "./ClassTable.tsx";
import { LeftOut, ResultFiles } from "./ResultFiles.tsx";
import { ResultTable, type ResultSort } from "./ResultTable.tsx";
import { closeCourseFile, type FileLeftOut } from "../../../app/records/course/opened-course-file.ts";
import { useReruns } from "./use-reruns.ts";
import { useResultCells } from "./use-result-cells.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/**
 * The results of learners as a table: sort, print, export as a spreadsheet; each program is run again and can be
 * opened.
 */
export function ResultView({ leftOut }: { readonly leftOut: readonly FileLeftOut[] }) {
  const t = useTexts("course-teach"),
    { results: words } = t,
    { table: byLearner } = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const { list: files, trouble } = useCollectedResults();
  const file = useRef<HTMLInputElement>(null);
  const all = useMemo(() => resultRows(files), [files]);
  const reruns = useReruns(all);
  const again = useMemo(() => new Map([...reruns].map(([key, { is }]) => [key, is])), [reruns]);
  const [sort, sortBy] = useState<ResultSort | null>(null);
  const [showsEarlier, showEarlier] = useState(false);
  const { day, heads, text, plain } = useResultCells(again);
  const people = learnerCount(files),
    [only] = files,
    isOne = files.length === 1;
  const [view, chooseView] = useState<"class" | "list">("class");
  const isByLearner = people > 1 && view === "class";
  const title = people === 1 && only ? words.title(plainName(only.result.name)) : words.gathered(String(people));
  const earlier = all.filter((row) => row.earlier).length;
  const rows = sortedRows(
    all.filter((row) => showsEarlier || !row.earlier),
    sort?.column ?? null,
    sort?.down ?? false,
    {
      again,
      compare: (a, b) => a.localeCompare(b, language, { numeric: true }),
    },
  );
  const isScored = rows.some(({ result }) => result.score !== null);
  const columns = RESULT_COLUMNS.filter(
    (column) => (column !== "name" || people > 1) && (column !== "made" || !isOne) && (column !== "score" || isScored),
  );
  const save = () => {
    const unit: Partial<Record<ResultColumn, string>> = { time: " (s)", machining: " (s)" };
    const counts = showsEarlier && earlier > 0;
    const head = RESULT_COLUMNS.map((column) => `${heads[column]}${unit[column] ?? ""}`);
    const cells = rows.map((row) => [
      ...RESULT_COLUMNS.map((column) => plain(row, column)),
      ...(counts ? [row.earlier ? words.no : words.yes] : []),
    ]);
    const csv = writeCsv([[...head, ...(counts ? [words.counts] : [])], ...cells], csvFormat(decimalSign(language)));
    downloadText(csv, `${title}.csv`);
  };
  return (
    <ModalDialog className="modal taught-wide" title={title} done={closeCourseFile}>
      <p>{isOne && only ? words.lead(day(only.result.made)) : words.several}</p>
      {trouble === "notKept" && <Message tone="warning">{words.notKept}</Message>}
      <LeftOut leftOut={leftOut} />
      {people > 1 && (
        <div className="teach-choices taught-ways" role="radiogroup" aria-label={byLearner.view}>
          {[true, false].map((each) => (
            <label key={String(each)} className="teach-check">
              <input
                type="radio"
                name="view of results"
                checked={isByLearner === each}
                onChange={() => chooseView(each ? "class" : "list")}
              />
              {each ? byLearner.byLearner : byLearner.list}
            </label>
          ))}
        </div>
      )}
      {all.length === 0 ? (
        <Message tone="info">{files.length === 0 ? words.nothing : words.empty}</Message>
      ) : isByLearner ? (
        <ClassTable title={title} rows={all} reruns={reruns} />
      ) : (
        <ResultTable
          title={title}
          rows={rows}
          columns={columns}
          heads={heads}
          text={text}
          waits={(key) => !again.has(key)}
          sort={sort}
          sortBy={sortBy}
        />
      )}
      {earlier > 0 && !isByLearner && (
        <label className="teach-check taught-ways">
          <input type="checkbox" checked={showsEarlier} onChange={() => showEarlier(!showsEarlier)} />
          {words.showEarlier(String(earlier))}
        </label>
      )}
      <ResultFiles files={files} rows={all} day={day} />
      <div className="modal-ways">
        <button type="button" className="button" onClick={() => file.current?.click()}>
          <Icon name="add" /> {words.add}
        </button>
        <input
          ref={file}
          type="file"
          multiple
          hidden
          accept=".json,.txt,application/json,text/plain"
          aria-label={words.add}
          onChange={(event) => {
            const chosen = [...(event.currentTarget.files ?? [])];
            event.currentTarget.value = "";
            if (chosen.length > 0) void addResults(chosen);
          }}
        />
        {rows.length > 0 && (
          <>
            {!isByLearner && (
              <button type="button" className="button" onClick={save}>
                <Icon name="download" /> {words.csv}
              </button>
            )}
            <button type="button" className="button" onClick={() => print()}>
              <Icon name="print" /> {words.print}
            </button>
          </>
        )}
      </div>
    </ModalDialog>
  );
}
