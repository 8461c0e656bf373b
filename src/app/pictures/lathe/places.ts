import { useMemo } from "react";
import type { Texts } from "../../../i18n/index.ts";
import type { AnyIssue } from "../../../i18n/message-texts.ts";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { joined } from "../../../view/bounds.ts";
import type { Bounds } from "../../../view/camera.ts";
import type { FindingEntry, FindingSpot } from "../../findings/entry.ts";
import { useFindings } from "../../findings/use-findings.ts";
import { useIssueText } from "../../calculation/issue-text.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** A finding of the list with a place in the picture. */
export interface PicturePlace {
  readonly id: string;
  /** "told": predicted by the learner before seeing the result. */
  readonly kind: FindingSpot["kind"] | "told";
  /** Number of a finding, letter of a region of residual material. */
  readonly mark: string;
  readonly place: Pt;
  readonly bounds: Bounds;
  /** Text and place in one sentence. */
  readonly line: string;
  /** The moment at which it is visible. */
  readonly position: PlayPosition;
  /** Null for a mark of a task. */
  readonly issue: AnyIssue | null;
}

/** A finding as a place of a picture; null if it has none there. `said`: its text. */
export function picturePlaceOf(
  { id, issue, block, spot }: FindingEntry,
  plane: FindingSpot["plane"],
  { inBlock }: Pick<Texts["findings"], "inBlock">,
  said: () => string,
): PicturePlace | null {
  if (spot?.plane !== plane) return null;
  const { kind, mark, place, bounds, position } = spot;
  return {
    id,
    kind,
    mark,
    place,
    bounds,
    line: block === null ? said() : `${said()} (${inBlock(String(block))})`,
    position,
    issue,
  };
}

/** The box round all findings; null without any. */
export const findingBounds = (places: readonly PicturePlace[]): Bounds | null =>
  places.reduce<Bounds | null>((all, { kind, bounds }) => (kind === "finding" ? joined(all, bounds) : all), null);

/** The findings that one of the two pictures shows, in the order of the list. */
export function usePlaces(plane: FindingSpot["plane"]): readonly PicturePlace[] {
  const entries = useFindings();
  const say = useIssueText();
  const t = useTexts().findings;
  return useMemo(
    () => entries.flatMap((entry) => picturePlaceOf(entry, plane, t, () => say(entry.issue)) ?? []),
    [entries, plane, say, t],
  );
}
