import { memo, useMemo, type ReactNode } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { PathStretch } from "../../../view/passes.ts";
import { contourShapes, type Shape } from "../../../view/scene.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { PassLines } from "./PassLines.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { stretchesOf } from "./use-paths.ts";

/*
 * Path and contour are drawn with the key that changes them; the rest of the picture follows after the paint.
 */

/** The newest run of the open work, while the picture still shows a previous one. */
export function useNewerRun(of: Run | null): Run | null {
  const newest = useOutcome.atOnce((s) => s.pictured?.run ?? null);
  return of && newest !== of ? newest : null;
}

/**
 * The lines of the path, from a newer run if there is one. `of`: the run of the picture; null if it is not of the open
 * work.
 */
export const NewestPath = memo(function NewestPath({
  of,
  stretches,
  playback,
  isLong,
}: {
  readonly of: Run | null;
  readonly stretches: readonly PathStretch[];
  readonly playback: PlaybackStore;
  readonly isLong: boolean;
}) {
  const ahead = useNewerRun(of),
    all = useSettings((s) => s.paths === "all");
  return (
    <PassLines
      stretches={ahead && all ? stretchesOf(ahead).stretches : stretches}
      playback={playback}
      isLong={isLong}
    />
  );
});

/** The finished contour, from a newer run if there is one: then the stock of the picture is not yet its own. */
export function NewestContour({
  of,
  shapes,
  children,
}: {
  readonly of: Run | null;
  readonly shapes: readonly Shape[];
  readonly children: (shapes: readonly Shape[], isOfStock: boolean) => ReactNode;
}) {
  const ahead = useNewerRun(of);
  return children(
    useMemo(() => (ahead ? contourShapes(ahead.operations.map((o) => o.plan.contour)) : shapes), [ahead, shapes]),
    ahead === null,
  );
}
