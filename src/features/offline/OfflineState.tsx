import { checkForUpdate, applyUpdate } from "./offline.ts";
import { Install } from "./Install.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useVersion } from "../../app/base/version.ts";

/** The version, whether it is stored completely, and the button to check for a newer one. */
export function OfflineState() {
  const t = useTexts("offline");
  const { kept, newer, looked } = useVersion();
  return (
    <>
      <div className="offline-state">
        <p role="status" className="small">
          {t.kept[kept]} {newer === "none" ? t.looked[looked] : t[newer]}
        </p>
        {/* Two buttons, so that none changes its action under the finger. */}
        {kept !== "impossible" && (
          <button
            type="button"
            className="button"
            disabled={looked === "looking" || looked === "coming"}
            onClick={() => void checkForUpdate()}
          >
            {t.look}
          </button>
        )}
        {newer !== "none" && (
          <button type="button" className="button" onClick={applyUpdate}>
            {newer === "elsewhere" ? t.reload : t.updateNow}
          </button>
        )}
      </div>
      <Install />
    </>
  );
}
