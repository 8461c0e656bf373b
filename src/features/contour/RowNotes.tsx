import { useMemo } from "react";
import type { Language } from "../../i18n/languages.ts";
import { noteText } from "../../i18n/drawing-note.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { dismissDrawnNotes, notesOn, useDrawnNotes, type DrawnNote } from "../../app/document/drawn-notes.ts";
import { useEditor } from "../../app/document/store.ts";
import { Message } from "../../app/base/Message.tsx";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";

interface Props {
  readonly row: ContourRow;
  /** Counted from 1. */
  readonly number: number;
  readonly language: Language;
}

const NO_ROWS: ReadonlySet<number> = new Set();

/** The elements with such notes, by index. */
export function useNotedRows(rows: readonly ContourRow[]): ReadonlySet<number> {
  const work = useEditor((s) => s.work),
    all = useDrawnNotes((s) => s.notes);
  return useMemo(
    () =>
      all.length === 0 ? NO_ROWS : new Set(rows.flatMap((row, i) => (notesOn(all, work, row).length > 0 ? [i] : []))),
    [rows, work, all],
  );
}

/** What the drawing left open at an element: shown until it is dismissed or the element is edited. */
export function RowNotes({ row, ...shown }: Props) {
  const work = useEditor((s) => s.work),
    all = useDrawnNotes((s) => s.notes);
  const own = all.length > 0 ? notesOn(all, work, row) : all;
  return own.length > 0 && <NotesShown own={own} {...shown} />;
}

function NotesShown({ own, number, language }: Omit<Props, "row"> & { readonly own: readonly DrawnNote[] }) {
  const t = texts(language).contour,
    words = useTextsOrNull("drawing");
  return (
    words &&
    own.map((each, i) => (
      <div key={i} className="contour-note">
        <Message tone={each.note.severity} className="small">
          {noteText(language, each.note, words)}
        </Message>
        <button
          type="button"
          className="button small"
          aria-label={t.dismissNote(number)}
          onClick={() => dismissDrawnNotes([each])}
        >
          {t.dismiss}
        </button>
      </div>
    ))
  );
}
