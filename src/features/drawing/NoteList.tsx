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
  /** Joins ends this far apart, mm. */
  readonly onGap: (gap: number) => void;
}

/** Most notes that are listed at once. */
const MOST = 40;

/** One note; with a place it leads there. */
function NoteLine({ listed, active, onActive, onShow, onGap }: Omit<Props, "notes"> & { readonly listed: ListedNote }) {
  const t = useTexts("drawing-import"),
    { note, text, number } = listed;
  if (number === null)
    return (
      <li className={`small ${note.severity}`}>
        <span className="note-text">
          <Icon name={note.severity} /> <span>{text}</span>
        </span>
      </li>
    );
  return (
    <li className={`small ${note.severity}${number === active ? " active" : ""}`}>
      <button
        type="button"
        className="button plain small note-text"
        onPointerEnter={() => onActive(number)}
        onPointerLeave={() => onActive(null)}
        onFocus={() => onActive(number)}
        onBlur={() => onActive(null)}
        onClick={() => onShow(listed)}
      >
        <span className="note-number">{number}</span> <span>{text}</span>
      </button>
      {note.code === "gapOpen" && (
        <button
          type="button"
          className="button small note-act"
          aria-label={t.closeGapOf(number)}
          onClick={() => onGap(Math.ceil(note.values.width * 100 + 0.5) / 100)}
        >
          {t.closeGap}
        </button>
      )}
    </li>
  );
}

/** What is doubtful or was joined; each note with a place leads there. */
export function NoteList({ notes, ...each }: Props) {
  const t = useTexts("drawing-import");
  const doubtful = notes.filter(({ note, number }) => note.severity !== "info" || number !== null);
  if (doubtful.length === 0) return null;
  return (
    <section className="drawing-notes" aria-label={t.notes}>
      <h3>{t.notes}</h3>
      <ul aria-live="polite">
        {doubtful.slice(0, MOST).map((listed, i) => (
          <NoteLine key={i} listed={listed} {...each} />
        ))}
      </ul>
      {doubtful.length > MOST && <p className="small soft">{t.moreNotes(doubtful.length - MOST)}</p>}
    </section>
  );
}

/** What was left out or converted, folded. */
export function LeftOut({ notes, ...each }: Props) {
  const t = useTexts("drawing-import");
  const others = notes.filter(({ note, number }) => note.severity === "info" && number === null);
  if (others.length === 0) return null;
  return (
    <details className="drawing-notes drawing-more">
      <summary>{t.leftOut(others.length)}</summary>
      <ul>
        {others.slice(0, MOST).map((listed, i) => (
          <NoteLine key={i} listed={listed} {...each} />
        ))}
      </ul>
    </details>
  );
}
