import { Icon } from "../app/base/Icon.tsx";
import { unsavedNames, unsavedWorks } from "../app/records/keep.ts";
import { fetchExportWorks } from "../features/works/index.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";

/** Downloads the works that exist only in this page. */
export function DownloadUnkept() {
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
