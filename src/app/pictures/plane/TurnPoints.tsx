import { useCallback, useId, useMemo } from "react";
import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import { withLegiblePoints } from "../../../view/approach/legible-points.ts";
import type { PicturePlace } from "../lathe/places.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useChosenApproaches } from "../selection.ts";
import { PlanePoints } from "./PlanePoints.tsx";
import { approachSpeech } from "./speech.ts";
import "../help/help.css";
import "./approach.css";

/** The points are already those of the theoretical tip. */
const NO_TIP = { x: 0, y: 0 };

/**
 * PS, PH, PA, PE and PN of the approaches of a turning tool, in the picture of the lathe; hidden where they would
 * overlap.
 */
export function TurnPoints({
  viewport,
  approaches,
  places,
}: {
  readonly viewport: Viewport;
  readonly places: readonly PicturePlace[];
  readonly approaches: readonly ApproachRun[];
}) {
  const id = useId(),
    lengths = useLengths();
  const speech = useMemo(() => approachSpeech(lengths, "ZX", NO_TIP), [lengths]);
  const chosen = useChosenApproaches(approaches),
    isNamed = useCallback((a: ApproachRun) => chosen.length === 0 || chosen.includes(a), [chosen]);
  return <PlanePoints {...{ viewport, approaches, isNamed, speech, places, id }} choose={withLegiblePoints} />;
}
