import { useEffect, useState } from "react";
import { goHome } from "../../app/document/go-home.ts";
import { isProgram, type Work } from "../../app/document/work.ts";
import { downloadBytes } from "../../app/base/download.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { takeAnswer } from "../../app/base/until-gone.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { WorkElsewhere } from "../../app/place/place.ts";
import { newestState, openWork } from "../../app/records/keep.ts";
import "./works.css";

/** Longest text that is shown to be copied by hand; a browser takes seconds over a longer one. */
const LONGEST_SHOWN = 200_000;

/** The text of a work, without calculating anything: of a cycle its typed values. */
const plainText = (work: Work): string => (isProgram(work) ? work.text : JSON.stringify(work, null, 1));

/** Saves a work without calculating anything: a program as its files, a cycle as a backup. */
async function saveAside(key: string, work: Work): Promise<void> {
  if (isProgram(work)) return (await import("../../app/records/rescue.ts")).downloadWorks([work]);
  const { writeArchive } = await import("../../app/records/archive.ts");
  downloadBytes(writeArchive({ works: [{ work: key, savedAt: 0, job: work }] }, false), "turnwise.zip");
}

/** In place of a work that was open when the page died: it may be the cause, so it opens only on request. */
export function DiedPage({ of: { work, name } }: { readonly of: WorkElsewhere }) {
  const { died: t, works: list } = useTexts("device");
  const { page } = useTexts("first");
  const [state, take] = useState<Work | null>(null);
  const [said, say] = useState("");
  useEffect(() => takeAnswer(() => newestState(work), take), [work]);
  const text = state ? plainText(state) : "";
  const copy = () =>
    navigator.clipboard.writeText(text).then(
      () => say(t.copied),
      () => say(t.notCopied),
    );
  const remove = async () => {
    await (await import("../../app/records/works.ts")).removeWorks([work]);
    goHome();
  };
  return (
    <main className="elsewhere-page">
      <h1>{t.title(name)}</h1>
      <p>{t.lead}</p>
      <div className="bring-buttons">
        <button type="button" className="button primary" onClick={() => void openWork(work)}>
          {t.open}
        </button>
        <button type="button" className="button" disabled={!state} onClick={() => void copy()}>
          <Icon name="copy" /> {t.copy}
        </button>
        <button type="button" className="button" disabled={!state} onClick={() => state && void saveAside(work, state)}>
          <Icon name="download" /> {t.save}
        </button>
        <button type="button" className="button" onClick={() => void remove()}>
          <Icon name="remove" /> {list.remove(name)}
        </button>
        <button type="button" className="button" onClick={goHome}>
          <Icon name="home" /> {list.back}
        </button>
        <a className="button" href="#/works">
          {page.works.title}
        </a>
      </div>
      <p role="status">{said}</p>
      {text !== "" && (
        <textarea className="died-text" readOnly rows={12} aria-label={t.text} value={text.slice(0, LONGEST_SHOWN)} />
      )}
    </main>
  );
}
