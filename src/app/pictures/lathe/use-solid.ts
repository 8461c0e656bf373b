import { useMemo, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { ShownWork } from "../solid/show.ts";
import type { Zooming } from "../solid/SolidView.tsx";
import type { PlayedScene, InitialScene } from "../../calculation/moving.ts";
import type { LatheResult } from "./use-material.ts";

/** The 3D view: its content while it is open, and its zoom once drawn. */
export interface SolidPlace {
  readonly work: ShownWork | null;
  /** Null while the section is shown. */
  readonly drawn: Zooming | null;
  readonly setDrawn: (drawn: Zooming | null) => void;
}

/** Measuring works in the section, so that is shown meanwhile. */
export function useSolid({
  run,
  shown,
  moving,
  waiting,
  measures,
}: {
  readonly run: Run;
  readonly shown: LatheResult | null;
  readonly moving: PlayedScene | null;
  readonly waiting: InitialScene | null;
  readonly measures: boolean;
}): SolidPlace {
  const asked = useSettings((s) => s.solid) && !measures;
  const [drawn, setDrawn] = useState<Zooming | null>(null);
  const work = useMemo(
    (): ShownWork | null =>
      asked
        ? {
            moving,
            waiting,
            simulation: shown?.run === run ? shown.simulation : null,
            blank: waiting?.blank.length ? waiting.blank : run.blank,
            steps: run.steps,
            spindles: run.spindles,
            clamping: run.clamping,
            contours: run.operations.map((o) => o.plan.contour),
          }
        : null,
    [asked, run, shown, moving, waiting],
  );
  return { work, drawn: asked ? drawn : null, setDrawn };
}
