import { useMemo } from "react";
import type { SheetTexts } from "../../i18n/tool-sheet-text.ts";
import type { SheetTools } from "../../program/tool-sheets/assignment.ts";
import { readEntry } from "../../program/tools/tool-entry.ts";
import { useIssueText } from "../../app/calculation/issue-text.ts";
import { Message } from "../../app/base/Message.tsx";

/** Most tools that are listed. */
const MOST = 200;
const NAMED = ["T", "NAME"];

/** The tools that a sheet makes, with the errors of each line. */
export function SheetPreview({
  tools: { rows, twice, unused },
  words: w,
}: {
  readonly tools: SheetTools;
  readonly words: SheetTexts;
}) {
  const say = useIssueText();
  const read = useMemo(
    () =>
      rows.map((row) => ({
        ...row,
        errors: readEntry({ id: "", cells: row.cells }).issues.filter(({ severity }) => severity === "error"),
      })),
    [rows],
  );
  const wrong = read.filter(({ errors }) => errors.length > 0).length;
  return (
    <section className="sheet-preview">
      <h3>
        <span role="status">
          {rows.length === 0 ? w.empty : w.tools(rows.length)}
          {wrong > 0 && (
            <>
              {" · "}
              <span className="tool-errors">{w.withErrors(wrong)}</span>
            </>
          )}
        </span>
      </h3>
      {twice.length > 0 && <Message tone="warning">{w.twiceNumbered(twice.join(", "))}</Message>}
      {unused.length > 0 && <p className="soft">{w.notUsed(unused.join(", "))}</p>}
      <ul className="import-changes">
        {read.slice(0, MOST).map(({ cells, line, isNumbered, errors }) => (
          <li key={line} className={errors.length > 0 ? "wrong" : ""}>
            <span>
              <b>{`T${cells.T ?? ""} ${cells.NAME ?? ""}`.trim()}</b>{" "}
              <span className="soft small">
                {w.line(line)}
                {!isNumbered && ` · ${w.proposedNumber}`}
              </span>
            </span>
            <span className="number small">
              {Object.entries(cells)
                .filter(([cell]) => !NAMED.includes(cell))
                .map(([cell, text]) => `${cell} ${text}`)
                .join(" · ")}
            </span>
            {errors.map((issue) => (
              <Message key={`${issue.code} ${issue.at}`} tone="error">
                <span>
                  <b className="number">{issue.at}</b>: {say(issue)}
                </span>
              </Message>
            ))}
          </li>
        ))}
      </ul>
    </section>
  );
}
