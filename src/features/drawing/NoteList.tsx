import type { DrawingNote } from "../../program/drawing/drawing.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** A note with its text; `number`: of its mark on the drawing, null without a place. */
export interface ListedNote {
  readonly note: DrawingNote;
  readonly text: string;
  readonly number: number | null;
}

interface Props {
  readonly notes: readonly ListedNote[];
  readonly active: number | null;
  readonly onActive: (number: number | null) => void;
  /** Shows the place of a note in the drawing. */
  readonly onShow: (note: ListedNote) => void;
}

/** Most notes that are listed at once. */
const MOST = 40;

/** Everything left out, joined or doubtful; a note with a place leads there. */
export function NoteList({ notes, active, onActive, onShow }: Props) {
  const t = useTexts("drawing-import");
  if (notes.length === 0) return null;
  return (
    <section className="drawing-notes" aria-label={t.notes}>
      <h3>{t.notes}</h3>
      <ul aria-live="polite">
        {notes.slice(0, MOST).map((listed, i) => {
          const { note, text, number } = listed;
          const content = (
            <>
              {number === null ? <Icon name={note.severity} /> : <span className="note-number">{number}</span>}{" "}
              <span>{text}</span>
            </>
          );
          return (
            <li key={i} className={`small ${note.severity}${number !== null && number === active ? " active" : ""}`}>
              {number === null ? (
                <span className="note-text">{content}</span>
              ) : (
                <button
                  type="button"
                  className="button plain small note-text"
                  onPointerEnter={() => onActive(number)}
                  onPointerLeave={() => onActive(null)}
                  onFocus={() => onActive(number)}
                  onBlur={() => onActive(null)}
                  onClick={() => onShow(listed)}
                >
                  {content}
                </button>
              )}
            </li>
          );
        })}
      </ul>
      {notes.length > MOST && <p className="small soft">{t.moreNotes(notes.length - MOST)}</p>}
    </section>
  );
}
