import { useMemo, useState } from "react";
import {
  proposedAssignment,
  toolsOfSheet,
  valuesIn,
  withWords,
  WORD_CELLS,
  wordsIn,
  type Assignment,
} from "../../program/tool-sheets/assignment.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import type { NamedSheet } from "./sheet-files.ts";
import { numbersTaken } from "./sheet-import.ts";
import { SheetColumn } from "./SheetColumn.tsx";
import { SheetPreview } from "./SheetPreview.tsx";
import { SheetWords } from "./SheetWords.tsx";

/** Assigns the columns of a sheet, and its words for types and orientations; the tools are shown as they change. */
export function SheetDialog({
  named,
  first,
  done,
}: {
  readonly named: NamedSheet;
  readonly first: Assignment;
  /** Null: given up. */
  readonly done: (assignment: Assignment | null) => void;
}) {
  const w = useTextsOrNull("tool-sheets");
  const { name, sheet } = named;
  const [assignment, setAssignment] = useState(() => withWords(sheet, first));
  const taken = useMemo(() => numbersTaken(), []);
  const tools = useMemo(() => toolsOfSheet(sheet, assignment, taken), [sheet, assignment, taken]);
  if (!w) return null;
  const title = w.title(name);
  const cells = assignment.columns.map((column) => column?.cell);
  const twice = [...new Set(cells.filter((cell, i) => cell && cells.indexOf(cell) !== i))];
  return (
    <ModalDialog isBare className="tool-dialog sheet-dialog" first="select" title={title} done={() => done(null)}>
      <h2>{title}</h2>
      <div className="tool-dialog-body">
        <p>{w.lead}</p>
        <ul className="sheet-columns" aria-label={w.columns}>
          {sheet.titles.map((column, at) =>
            column.trim() === "" && valuesIn(sheet, at).length === 0 ? null : (
              <SheetColumn
                key={at}
                sheet={sheet}
                at={at}
                choice={assignment.columns[at] ?? null}
                words={w}
                onChoose={(choice) =>
                  setAssignment((now) =>
                    withWords(sheet, { ...now, columns: now.columns.map((old, i) => (i === at ? choice : old)) }),
                  )
                }
              />
            ),
          )}
        </ul>
        {twice.map((cell) => cell && <p key={cell}>{w.twice(cell)}</p>)}
        {WORD_CELLS.map((cell) => (
          <SheetWords
            key={cell}
            cell={cell}
            all={wordsIn(sheet, assignment, cell)}
            chosen={assignment.words[cell]}
            words={w}
            onChoose={(word, value) =>
              setAssignment((now) => ({
                ...now,
                words: { ...now.words, [cell]: { ...now.words[cell], [word]: value } },
              }))
            }
          />
        ))}
        <SheetPreview tools={tools} words={w} />
      </div>
      <div className="tool-dialog-ways">
        <button
          type="button"
          className="button primary"
          disabled={tools.rows.length === 0}
          onClick={() => done(assignment)}
        >
          {w.go}
        </button>
        <button type="button" className="button" onClick={() => setAssignment(proposedAssignment(sheet))}>
          {w.again}
        </button>
        <button type="button" className="button" onClick={() => done(null)}>
          {w.cancel}
        </button>
      </div>
    </ModalDialog>
  );
}
