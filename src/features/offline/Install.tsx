import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useVersion } from "../../app/base/version.ts";

/** Safari on a phone or tablet, not started from the home screen: only there a page is installed by hand. */
export const installsByHand = (navigator: object & { readonly maxTouchPoints?: number }): boolean =>
  "standalone" in navigator && navigator.standalone === false && (navigator.maxTouchPoints ?? 0) > 0;

/** Installs the page where the browser offers it, or says how; nothing elsewhere. */
export function Install() {
  const t = useTexts("offline").install;
  const offer = useVersion((v) => v.install);
  if (!offer) return installsByHand(navigator) && <p className="small">{t.byHand}</p>;
  const install = () => {
    // The browser accepts one call only, and makes a new offer after a refusal.
    useVersion.setState({ install: null });
    void offer.prompt().catch(() => undefined);
  };
  return (
    <div className="offline-state">
      <p className="small">{t.why}</p>
      <button type="button" className="button" onClick={install}>
        <Icon name="download" /> {t.install}
      </button>
    </div>
  );
}
