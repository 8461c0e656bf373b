import { useEffect } from "react";
import { formatNumber } from "../../i18n/number.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { undo } from "../../app/document/steps.ts";
import { keepFocus } from "./keep-focus.ts";
import { clearAppliedValue, useAppliedValue } from "./applied-value.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Names the value applied from this page, and offers undo. */
export function AppliedValueNote({ page }: { readonly page: string }) {
  const t = useTexts("guide");
  const language = useSettings((s) => s.language);
  const taken = useAppliedValue();
  useEffect(clearAppliedValue, [page]);
  return (
    <div className="guide-taken" role="status">
      {taken && (
        <p>
          <Icon name="check" />
          <span>
            {t.taken(taken.letter, typeof taken.value === "number" ? formatNumber(language, taken.value) : taken.value)}
          </span>
          <button
            type="button"
            className="button"
            onClick={(event) => {
              keepFocus(event.currentTarget, "main");
              undo(taken.step.document);
            }}
          >
            <Icon name="undo" /> {t.restoreValue}
          </button>
        </p>
      )}
    </div>
  );
}
