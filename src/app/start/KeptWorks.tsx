import { useState } from "react";
import { cycleByNumber } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { usePlace } from "../place.ts";
import { openWork, refreshWorks, useKeeping } from "../saving/keep.ts";
import { forgetWork, keepWork, type Kept } from "../saving/device.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { isProgram } from "../work.ts";

/** Earlier programs on this device, newest first. */
export function KeptWorks() {
  const { start: t, undo } = useTexts().page;
  const [removed, setRemoved] = useState<Kept | null>(null);
  const language = useSettings((s) => s.language);
  const works = useKeeping((k) => k.works).filter(({ file }) => isProgram(file.job) || cycleByNumber(file.job.cycle));
  if (works.length === 0 && !removed) return null;
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" });

  return (
    <section className="kept-works" aria-label={t.kept}>
      <h2>{t.kept}</h2>
      <ul>
        {works.map(({ work, file }) => (
          <li key={work}>
            <button
              type="button" className="button kept-open" aria-label={t.continueWork(file.job.name)}
              onClick={() => {
                usePlace.setState({ section: "prompts", prompt: null });
                void openWork(work);
              }}
            >
              <span className="number card-number">{isProgram(file.job) ? ".h" : file.job.cycle}</span>
              <b>{file.job.name}</b>
              <span className="soft small">{t.changed(when.format(file.savedAt))}</span>
            </button>
            <button
              type="button" className="button icon plain" aria-label={t.forget(file.job.name)}
              onClick={() => {
                setRemoved({ work, file });
                void forgetWork(work).then(refreshWorks);
              }}
            >
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
      <p role="status" className="kept-removed">
        {removed && (
          <>
            {t.removed(removed.file.job.name)}
            <button
              type="button" className="button"
              onClick={() => {
                setRemoved(null);
                void keepWork(removed.work, removed.file.job).then(refreshWorks);
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
