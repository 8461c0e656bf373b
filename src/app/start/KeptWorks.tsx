import { useState } from "react";
import { menuCycle } from "../chooser/menu.ts";
import { Icon } from "../Icon.tsx";
import { usePlace } from "../place.ts";
import { openWork, putBack, removeWork, useKeeping } from "../saving/keep.ts";
import { useSettings } from "../settings/settings.ts";
import { useFirstTexts } from "../settings/use-first-texts.ts";
import type { Work } from "../work.ts";

/** Works that are listed before all are asked for. */
const FIRST = 20;

/** Earlier programs on this device, newest first. */
export function KeptWorks() {
  const { start: t, undo } = useFirstTexts().page;
  const [removed, setRemoved] = useState<{ readonly work: string; readonly job: Work } | null>(null);
  const [all, showAll] = useState(false);
  const language = useSettings((s) => s.language);
  const works = useKeeping((k) => k.works).filter(({ cycle }) => cycle === null || menuCycle(cycle));
  if (works.length === 0 && !removed) return null;
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" });

  return (
    <section className="kept-works" aria-label={t.kept}>
      <h2>{t.kept}</h2>
      <ul>
        {(all ? works : works.slice(0, FIRST)).map(({ work, savedAt, name, cycle }) => (
          <li key={work}>
            <button type="button" className="button kept-open" aria-label={t.continueWork(name)} onClick={() => {
              usePlace.setState({ section: "prompts", prompt: null });
              void openWork(work);
            }}>
              <span className="number card-number">{cycle ?? ".h"}</span>
              <b>{name}</b>
              <span className="soft small">{t.changed(when.format(savedAt))}</span>
            </button>
            <button type="button" className="button icon plain" aria-label={t.forget(name)}
              onClick={() => void removeWork(work).then((job) => setRemoved(job && { work, job }))}
            >
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
      {!all && works.length > FIRST && (
        <button type="button" className="button kept-all" onClick={() => showAll(true)}>{t.showAll(works.length)}</button>
      )}
      <p role="status" className="kept-removed">
        {removed && (
          <>
            {t.removed(removed.job.name)}
            <button type="button" className="button" onClick={() => {
              setRemoved(null);
              void putBack(removed.work, removed.job);
            }}>
              <Icon name="undo" /> {undo}
            </button>
          </>
        )}
      </p>
    </section>
  );
}
