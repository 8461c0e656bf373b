import { useMemo, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { ChuckDrawing } from "../../../view/material/chuck.ts";
import type { ShownWork } from "../solid/show.ts";
import type { PlayedScene, InitialScene } from "../../calculation/moving.ts";
import type { Sight } from "./place-projection.ts";
import type { LatheResult } from "./use-material.ts";

/** The 3D view: its content while it is open, and its sight once drawn. */
export interface SolidPlace {
  readonly work: ShownWork | null;
  /** Null while the section is shown. */
  readonly drawn: Sight | null;
  readonly setDrawn: (drawn: Sight | null) => void;
}

const NOTHING_HELD = { cut: null, seen: null } as const;

/** Measuring works in the section, so that is shown meanwhile. */
export function useSolid({
  run,
  shown,
  moving,
  waiting,
  chuck,
  measures,
}: {
  readonly run: Run;
  readonly shown: LatheResult | null;
  readonly moving: PlayedScene | null;
  readonly waiting: InitialScene | null;
  /** The clamping as the section draws it: both are cut off at the same places. */
  readonly chuck: ChuckDrawing | null;
  readonly measures: boolean;
}): SolidPlace {
  const asked = useSettings((s) => s.solid) && !measures;
  const { cut, seen } = chuck ?? NOTHING_HELD;
  const [drawn, setDrawn] = useState<Sight | null>(null);
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
            clamping: run.clamping && cut && seen ? { of: run.clamping, cut, seen } : null,
            contours: run.operations.map((o) => o.plan.contour),
          }
        : null,
    [asked, run, shown, moving, waiting, cut, seen],
  );
  return { work, drawn: asked ? drawn : null, setDrawn };
}
