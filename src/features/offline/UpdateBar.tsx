import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { applyUpdate } from "./offline.ts";
import { useVersion } from "../../app/base/version.ts";

/** Announces a newer version. The page stays unchanged until the button is clicked. */
export function UpdateBar() {
  const t = useTexts("offline");
  const newer = useVersion((v) => v.newer);
  return (
    <p className="notice">
      <Icon name="info" /> <span>{newer === "elsewhere" ? t.elsewhere : t.ready}</span>
      <button type="button" className="button" onClick={applyUpdate}>
        {newer === "elsewhere" ? t.reload : t.updateNow}
      </button>
      <button type="button" className="button plain" onClick={() => useVersion.setState({ later: true })}>
        {t.later}
      </button>
    </p>
  );
}
