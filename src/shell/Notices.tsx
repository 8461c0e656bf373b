import { Icon } from "../app/base/Icon.tsx";
import { useNotices, withdraw } from "../app/base/notices.ts";
import { lazyPart } from "../app/base/parts.ts";
import { dismissDamaged, useSavedWorks } from "../app/records/keep.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";

const DownloadUnkept = lazyPart(async () => ({ default: (await import("./DownloadUnkept.tsx")).DownloadUnkept }));

/** Notices about saved work, until they are dismissed. */
export function Notices() {
  const t = useTexts("first").page.notice;
  const { damaged } = useSavedWorks();
  const { notices } = useNotices();
  const line = (key: (typeof notices)[number] | "damaged", text: string) => (
    <p key={key} className="notice">
      <Icon name="info" /> <span>{text}</span>
      {(key === "notKept" || key === "storageFull" || key === "storageSilent") && <DownloadUnkept />}
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
