import { catalogue } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { usePlace } from "../place.ts";
import { openWork, refreshWorks, useKeeping } from "../saving/keep.ts";
import { forgetWork } from "../saving/device.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";

/** Earlier programs on this device, newest first. */
export function KeptWorks() {
  const t = useTexts().page.start;
  const language = useSettings((s) => s.language);
  const works = useKeeping((k) => k.works).filter(({ file }) => catalogue.some((c) => c.number === file.job.cycle));
  if (works.length === 0) return null;
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
              <span className="number card-number">{file.job.cycle}</span>
              <b>{file.job.name}</b>
              <span className="soft small">{t.changed(when.format(file.savedAt))}</span>
            </button>
            <button
              type="button" className="button icon plain" aria-label={t.forget(file.job.name)}
              onClick={() => void forgetWork(work).then(refreshWorks)}
            >
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
