import { useMemo } from "react";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { findingsOf } from "../../app/findings/findings.ts";
import { issueText } from "../../app/calculation/issue-text.ts";
import { picturePlaceOf, type PicturePlace } from "../../app/pictures/lathe/places.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The marks in the picture of a lesson: the findings of its run, and residual material. */
export function useLessonPlaces(outcome: Outcome): readonly PicturePlace[] {
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  return useMemo(
    () =>
      findingsOf(null, outcome).flatMap((entry) => {
        const cycle = entry.operation === null ? null : (outcome.run.operations[entry.operation]?.cycle ?? null);
        return picturePlaceOf(entry, "ZX", texts.findings, () => issueText(texts, language, entry.issue, cycle)) ?? [];
      }),
    [outcome, texts, language],
  );
}
