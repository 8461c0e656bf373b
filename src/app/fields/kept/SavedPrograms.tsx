import { useMemo, useState } from "react";
import { menuCycle } from "../chooser/menu.ts";
import { Icon } from "../../base/Icon.tsx";
import { toFirstPrompt } from "../../place/place.ts";
import { WORKS } from "../../document/documents.ts";
import { undoStep } from "../../document/history.ts";
import { keptPictures } from "../../records/kept-picture.ts";
import { openWork, useSavedWorks } from "../../records/keep.ts";
import { useWorksInOtherTabs } from "../../records/use-works-in-other-tabs.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { ProgramThumbnail } from "./ProgramThumbnail.tsx";

/** Works listed here; the page of all works has the rest. */
const FIRST = 8;

/** Opens a work of the list at its beginning. */
export async function openSaved(work: string): Promise<void> {
  toFirstPrompt();
  await openWork(work);
}

/** Deletes a work; false if another tab has it open. The code is loaded on demand. */
async function removeSaved(work: string): Promise<boolean> {
  const { removeWorks } = await import("../../records/works.ts");
  return (await removeWorks([work])).gone.length > 0;
}

/** Earlier programs on this device, newest first. */
export function SavedPrograms() {
  const {
    page: { start: t, undo },
    menu,
  } = useTexts("first");
  const [removed, setRemoved] = useState<string | null>(null);
  const elsewhere = useWorksInOtherTabs();
  const language = useSettings((s) => s.language);
  const all = useSavedWorks((k) => k.works);
  // Pictures are made while a work is open, not while the list is shown.
  const pictures = useMemo(() => (all.length > 0 ? keptPictures() : {}), [all]);
  const works = all.filter(({ cycle }) => cycle === null || menuCycle(cycle));
  if (works.length === 0 && removed === null) return null;
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" });

  return (
    <section className="kept-works" aria-label={t.kept}>
      <h2>{t.kept}</h2>
      <ul>
        {works.slice(0, FIRST).map(({ work, savedAt, name, cycle, task }) => (
          <li key={work}>
            <button
              type="button"
              className="button kept-open"
              aria-label={t.continueWork(name)}
              onClick={() => void openSaved(work)}
            >
              <ProgramThumbnail seen={pictures[work]} cycle={cycle} />
              <span className="kept-words">
                <b className="kept-name">{name}</b>
                <span className="small kept-of">
                  <span className="number card-number">{cycle ?? ".h"}</span> {task !== undefined && <b>{t.task}</b>}
                  {cycle !== null && menu.of[cycle]?.name}
                </span>
                <span className="soft small">
                  {t.changed(when.format(savedAt))}
                  {elsewhere.has(work) && <b>{` · ${t.isElsewhere}`}</b>}
                </span>
              </span>
            </button>
            <button
              type="button"
              className="button icon plain"
              aria-label={t.forget(name)}
              disabled={elsewhere.has(work)}
              onClick={() => void removeSaved(work).then((gone) => gone && setRemoved(name))}
            >
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
      {works.length > 0 && (
        <a className="button kept-all" href="#/works">
          {t.allWorks(works.length)}
        </a>
      )}
      <p role="status" className="kept-removed">
        {removed !== null && (
          <>
            {t.removed(removed)}
            <button
              type="button"
              className="button"
              aria-label={`${undo} – ${t.removed(removed)}`}
              onClick={() => {
                setRemoved(null);
                undoStep(WORKS);
              }}
            >
              <Icon name="undo" /> {undo}
            </button>
          </>
        )}
      </p>
    </section>
  );
}
