import { useMemo, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { toPlace, type Place } from "../../../view/camera.ts";
import { moveAt, positionNear } from "../../../view/pick.ts";
import { createHover, type Hover } from "./Chosen.tsx";
import { chooseMove, elementNear } from "../selection.ts";
import { useEditor } from "../../document/store.ts";
import { useTaskMarks } from "./task-marks.ts";
import type { Viewport } from "./viewport.ts";

/** Distance at which a pointer picks a move, pixels. */
const NEAR = 10;

/** Choosing in the picture: a click takes the tool to the move under it, hovering shows which one that would be. */
export function usePicking({
  run,
  viewport,
  shown,
  onMove,
}: {
  readonly run: Run;
  readonly viewport: Viewport;
  /** The visible moves. */
  readonly shown: (step: number) => boolean;
  readonly onMove: ((step: number) => void) | undefined;
}): { readonly hover: Hover; readonly over: (at: Place | null) => void; readonly tap: (at: Place) => void } {
  const [hover] = useState(createHover);
  return useMemo(() => {
    const reach = () => NEAR / viewport.get().scale;
    const stepAt = (at: Place) => moveAt(run.steps, toPlace(viewport.get(), at), reach(), shown);
    return {
      hover,
      over: (at) => hover.set(at && stepAt(at)),
      tap(at) {
        const step = stepAt(at),
          place = toPlace(viewport.get(), at),
          { told } = useTaskMarks.getState();
        if (told?.onPoint) return told.onPoint(place);
        const rows = useEditor.getState().job?.contour;
        const element = rows ? elementNear(rows, place, reach()) : null;
        if (step === null) return;
        hover.set(null);
        chooseMove(run, positionNear(run.steps, step, place), element);
        onMove?.(step);
      },
    };
  }, [hover, run, viewport, shown, onMove]);
}
