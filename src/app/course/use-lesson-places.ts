import { useMemo } from "react";
import type { Outcome } from "../engine/outcome.ts";
import { findingsOf } from "../findings/findings.ts";
import { issueText } from "../issue-text.ts";
import type { LookAt } from "../lathe/places.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";

/** What the picture of a lesson marks: what was found in the run of its program, and what stays in the part. */
export function useLessonPlaces(outcome: Outcome): readonly LookAt[] {
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  return useMemo(() =>
    findingsOf(null, outcome).flatMap(({ id, issue, block, spot, operation }): LookAt[] => {
      if (spot?.plane !== "ZX") return [];
      const cycle = operation === null ? null : outcome.run.operations[operation]?.cycle ?? null;
      const said = issueText(texts, language, issue, cycle);
      const line = block === null ? said : `${said} (${texts.findings.inBlock(String(block))})`;
      return [{
        id,
        kind: spot.kind,
        mark: spot.mark,
        place: spot.place,
        bounds: spot.bounds,
        line,
        position: spot.position,
        issue,
      }];
    }), [outcome, texts, language]);
}
