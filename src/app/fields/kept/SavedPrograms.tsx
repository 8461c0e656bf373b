import { useMemo, useState } from "react";
import { menuCycle } from "../chooser/menu.ts";
import { Icon } from "../../base/Icon.tsx";
import { toFirstPrompt } from "../../place/place.ts";
import { WORKS } from "../../document/documents.ts";
import { undoStep } from "../../document/history.ts";
import type { Thumbnail } from "../../../view/thumbnail.ts";
import type { WorkSummary } from "../../records/device.ts";
import { keptPictures } from "../../records/kept-picture.ts";
import { openWork, useSavedWorks } from "../../records/keep.ts";
import { useWorksInOtherTabs } from "../../records/use-works-in-other-tabs.ts";
import { momentWriter } from "../../base/clock-text.ts";
import { RowGuard } from "../../base/RowGuard.tsx";
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

interface RowProps {
  readonly of: WorkSummary;
  readonly seen: Thumbnail | undefined;
  readonly when: string;
  readonly isElsewhere: boolean;
  readonly onRemoved: () => void;
}

function SavedRow({ of: { work, name, cycle, task }, seen, when, isElsewhere, onRemoved }: RowProps) {
  const {
    page: { start: t },
    menu,
  } = useTexts("first");
  const kind = [task === undefined ? null : t.task, cycle === null ? t.program : menu.of[cycle]?.name];
  return (
    <li>
      <button
        type="button"
        className="button kept-open"
        aria-label={t.continueWork(name)}
        onClick={() => void openSaved(work)}
      >
        <ProgramThumbnail seen={seen} cycle={cycle} />
        <span className="kept-words">
          <b className="kept-name">{name}</b>
          <span className="small kept-of">
            {cycle !== null && <span className="number card-number">{cycle}</span>}{" "}
            {kind.filter((each) => each !== null && each !== undefined).join(" · ")}
          </span>
          <span className="soft small">
            {t.changed(when)}
            {isElsewhere && <b>{` · ${t.isElsewhere}`}</b>}
          </span>
        </span>
      </button>
      <button
        type="button"
        className="button icon plain"
        aria-label={t.forget(name)}
        disabled={isElsewhere}
        onClick={() => void removeSaved(work).then((gone) => gone && onRemoved())}
      >
        <Icon name="close" />
      </button>
    </li>
  );
}

/** Earlier programs on this device, newest first; exercises in a row that opens. */
export function SavedPrograms() {
  const {
    page: { start: t, undo },
  } = useTexts("first");
  const [removed, setRemoved] = useState<string | null>(null);
  const elsewhere = useWorksInOtherTabs();
  const language = useSettings((s) => s.language);
  const all = useSavedWorks((k) => k.works);
  // Pictures are made while a work is open, not while the list is shown.
  const pictures = useMemo(() => (all.length > 0 ? keptPictures() : new Map<string, never>()), [all]);
  const works = all.filter(({ cycle }) => cycle === null || menuCycle(cycle));
  if (works.length === 0 && removed === null) return null;
  const when = momentWriter(language);
  const exercises = works.filter(({ task }) => task !== undefined);
  const programs = works.filter(({ task }) => task === undefined);
  const row = (of: WorkSummary) => (
    <RowGuard key={of.work} name={of.name}>
      <SavedRow
        of={of}
        seen={pictures.get(of.work)}
        when={when(of.savedAt)}
        isElsewhere={elsewhere.has(of.work)}
        onRemoved={() => setRemoved(of.name)}
      />
    </RowGuard>
  );

  return (
    <section className="kept-works" aria-label={t.kept}>
      <h2>{t.kept}</h2>
      {programs.length > 0 && <ul>{programs.slice(0, FIRST).map(row)}</ul>}
      {exercises.length > 0 && (
        <details className="kept-exercises" open={programs.length === 0}>
          <summary>{t.exercises(exercises.length)}</summary>
          <ul>{exercises.slice(0, FIRST).map(row)}</ul>
        </details>
      )}
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
