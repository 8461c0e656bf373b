import { Icon } from "./Icon.tsx";
import { dismissMissing, fetchMissing, useMissing } from "./parts.ts";
import { useTexts } from "./settings/use-texts.ts";

/** Says that a part of the page could not be loaded. The open work stays. */
export function MissingPart() {
  const t = useTexts("first").page.notice;
  const missing = useMissing((m) => m.missing);
  if (missing === "no") return null;
  return (
    <p className="notice">
      <Icon name="info" /> <span>{t.missing[missing]}</span>
      {missing === "gone" && (
        <button type="button" className="button" onClick={() => location.reload()}>
          {t.reload}
        </button>
      )}
      <button type="button" className="button" onClick={fetchMissing}>
        {t.tryAgain}
      </button>
      <button type="button" className="button icon plain" aria-label={t.dismiss} onClick={dismissMissing}>
        <Icon name="close" />
      </button>
    </p>
  );
}
