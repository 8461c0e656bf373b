import { useId, useState } from "react";
import { Drawing } from "../chooser/Drawing.tsx";
import { menuCycle } from "../chooser/menu.ts";
import { Icon } from "../Icon.tsx";
import { usePlace } from "../place.ts";
import { keptPicture } from "../saving/kept-picture.ts";
import { openWork, putBack, removeWork, useKeeping } from "../saving/keep.ts";
import { useSettings } from "../settings/settings.ts";
import { useFirstTexts } from "../settings/use-first-texts.ts";
import type { Work } from "../work.ts";
import { PartPicture } from "./PartPicture.tsx";

/** Works that are listed before all are asked for. */
const FIRST = 8;

/** Opens a work of the list at its beginning. */
export async function openKept(work: string): Promise<void> {
  usePlace.setState({ section: "prompts", prompt: null });
  await openWork(work);
}

/** A work in small: the part as it was last seen, or what its cycle makes. */
function KeptPicture({ work, cycle }: { readonly work: string; readonly cycle: number | null }) {
  const id = useId();
  const seen = keptPicture(work);
  if (seen) return <PartPicture of={seen} />;
  const known = cycle === null ? undefined : menuCycle(cycle);
  return <Drawing of={known?.pictograms[0]} id={id} turned={known?.group === "transverse"} />;
}

/** Earlier programs on this device, newest first. */
export function KeptWorks() {
  const { page: { start: t, undo }, menu } = useFirstTexts();
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
            <button type="button" className="button kept-open" aria-label={t.continueWork(name)} onClick={() => void openKept(work)}>
              <KeptPicture work={work} cycle={cycle} />
              <span className="kept-words">
                <b className="kept-name">{name}</b>
                <span className="small kept-of">
                  <span className="number card-number">{cycle ?? ".h"}</span> {cycle !== null && menu.of[cycle]?.name}
                </span>
                <span className="soft small">{t.changed(when.format(savedAt))}</span>
              </span>
            </button>
            <button type="button" className="button icon plain" aria-label={t.forget(name)} onClick={() =>
              void removeWork(work).then((job) => setRemoved(job && { work, job }))}
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
