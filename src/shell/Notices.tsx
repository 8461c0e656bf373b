import { Icon } from "../app/base/Icon.tsx";
import { useNotices, withdraw } from "../app/base/notices.ts";
import { dismissDamaged, unsavedNames, unsavedWorks, useSavedWorks } from "../app/records/keep.ts";
import { fetchExportWorks } from "../features/works/index.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";

/** Downloads the works that exist only in this page. */
function DownloadUnkept() {
  const t = useTexts("first").page.notice;
  const works = unsavedWorks();
  if (works.length === 0) return null;
  return (
    <>
      <button
        type="button"
        className="button"
        onClick={() => void import("../app/records/rescue.ts").then(({ downloadWorks }) => downloadWorks(works))}
      >
        <Icon name="download" /> {t.downloadUnkept}
      </button>
      <button
        type="button"
        className="button"
        onClick={() => void fetchExportWorks().then(({ saveWorks }) => saveWorks(unsavedNames()))}
      >
        <Icon name="download" /> {t.archiveUnkept}
      </button>
    </>
  );
}

/** Notices about saved work, until they are dismissed. */
export function Notices() {
  const t = useTexts("first").page.notice;
  const { damaged } = useSavedWorks();
  const { notices } = useNotices();
  const line = (key: (typeof notices)[number] | "damaged", text: string) => (
    <p key={key} className="notice">
      <Icon name="info" /> <span>{text}</span>
      {(key === "notKept" || key === "storageFull") && <DownloadUnkept />}
      <button
        type="button"
        className="button icon plain"
        aria-label={t.dismiss}
        onClick={() => (key === "damaged" ? dismissDamaged() : withdraw(key))}
      >
        <Icon name="close" />
      </button>
    </p>
  );
  return (
    <div className="notices" role="status">
      {damaged > 0 && line("damaged", t.damaged(damaged))}
      {notices.map((key) => line(key, t[key]))}
    </div>
  );
}
