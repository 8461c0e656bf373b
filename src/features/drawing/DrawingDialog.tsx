import { useCallback, useId, useMemo, useRef, useState } from "react";
import { noteText } from "../../i18n/drawing-note.ts";
import { closeDrawing, openDrawing, type DrawingRequest } from "../../app/document/drawing-request.ts";
import { askForDrawing } from "../../app/records/files/ask-for-drawing.ts";
import { offeredCycles } from "../../app/fields/chooser/menu.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { DrawingNote } from "../../program/drawing/drawing.ts";
import { DRAWING_KINDS } from "../../program/drawing/endings.ts";
import { DrawingPicker } from "./DrawingPicker.tsx";
import { listedNotes } from "./listed-notes.ts";
import { planContour, takeContour } from "./take-contour.ts";
import { useContour, useOpenedDrawing } from "./use-opened-drawing.ts";
import "./drawing.css";

/** Cycles that cut a contour, for a drawing that becomes a new program. */
const CYCLES = offeredCycles(false).filter(({ free }) => free);

/** Takes a contour from a drawing, picked on the picture, into a table or a new program. */
export function DrawingDialog({ request }: { readonly request: DrawingRequest }) {
  const t = useTexts("drawing-import"),
    words = useTexts("drawing"),
    { menu, start } = useTexts("first"),
    language = useSettings((s) => s.language),
    id = useId();
  const dialog = useRef<HTMLDialogElement>(null);
  const [cycle, setCycle] = useState(CYCLES[0]?.number ?? 0);
  const { opening, readAs, change } = useOpenedDrawing(request.file);
  const { target } = request;
  const opened = opening.kind === "open" ? opening.opened : null;
  const made = useContour(opened),
    contour = made?.contour ?? null,
    isMade = made !== null && made.choice === opened?.choice;
  const textOf = useCallback((note: DrawingNote) => noteText(language, note, words), [language, words]);
  const notes = useMemo(
    () => (opened && contour ? listedNotes([...contour.notes, ...opened.drawing.notes], textOf) : []),
    [opened, contour, textOf],
  );
  const close = () => dialog.current?.close();
  const chooseOther = async () => {
    const file = await askForDrawing();
    if (file) openDrawing(file, target);
  };
  return (
    <ModalDialog
      ref={dialog}
      className="modal drawing-dialog"
      title={t.title}
      {...(opened && { heading: `${t.title} · ${opened.file.name}` })}
      first=".drawing-sheet, .drawing-choose"
      done={closeDrawing}
      actions={
        opened && (
          <button
            type="button"
            className="button drawing-other"
            aria-label={t.chooseOther}
            onClick={() => void chooseOther()}
          >
            <Icon name="drawing" /> <span>{t.chooseOther}</span>
          </button>
        )
      }
    >
      {opened && made ? (
        <DrawingPicker key={opened.name} opened={opened} made={made} notes={notes} onGiven={readAs} onChange={change} />
      ) : (
        <div className="drawing-empty">
          {opening.kind === "refused" && (
            <div role="alert">
              {listedNotes(opening.notes, textOf).map(({ note, text }, i) => (
                <Message key={i} tone={note.severity}>
                  {i === 0 ? `${opening.name}: ${text}` : text}
                </Message>
              ))}
            </div>
          )}
          {opening.kind === "reading" || opened ? (
            <p role="status">{t.reading}</p>
          ) : (
            <>
              <p>{t.drop(DRAWING_KINDS)}</p>
              <button type="button" className="button primary drawing-choose" onClick={() => void chooseOther()}>
                {t.choose}
              </button>
            </>
          )}
        </div>
      )}
      {/* While a drawing is read, nothing takes the focus that its picture gets then. */}
      {opening.kind !== "reading" && (made || !opened) && (
        <footer className="drawing-foot">
          <span className="small soft drawing-what">{target && target.count > 0 && t.replaces(target.count)}</span>
          {!target && (
            <label className="drawing-cycle" htmlFor={`${id}-cycle`}>
              <span className="small">{t.cycle}</span>
              <select
                id={`${id}-cycle`}
                className="select"
                value={cycle}
                onChange={(e) => setCycle(Number(e.currentTarget.value))}
              >
                {CYCLES.map(({ number }) => (
                  <option key={number} value={number}>
                    {`${number} ${menu.of[number]?.name ?? ""}`.trim()}
                  </option>
                ))}
              </select>
            </label>
          )}
          <button type="button" className="button drawing-cancel" onClick={close}>
            {t.cancel}
          </button>
          {!target && (
            <button
              type="button"
              className="button"
              disabled={!contour || !isMade || contour.rows.length < 2}
              onClick={() => {
                if (!opened || !contour) return;
                close();
                void planContour(opened, contour);
              }}
            >
              {start.doors.plan}
            </button>
          )}
          <button
            type="button"
            className="button primary"
            disabled={!contour || !isMade || contour.rows.length < 2}
            onClick={() => {
              if (!opened || !contour) return;
              close();
              void takeContour({ target, cycle, name: opened.file.name, contour, choice: opened.choice });
            }}
          >
            {target ? t.take : t.newProgram}
          </button>
        </footer>
      )}
    </ModalDialog>
  );
}
