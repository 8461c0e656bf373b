import { useMemo, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { motionAt, type NamedLead } from "../../../view/approach/plane-pick.ts";
import { toPlace, type Place } from "../../../view/camera.ts";
import { createHover, type Hover } from "../lathe/Chosen.tsx";
import type { MovePointed } from "../lathe/LatheView.tsx";
import type { Viewport } from "../lathe/viewport.ts";
import { chooseMilled } from "../selection.ts";

/** Distance at which a pointer picks a motion or a named point, pixels. */
const NEAR = 10;

/**
 * Choosing in the working plane: a click takes the tool to the motion under it, hovering shows which one that would be.
 */
export function usePlanePicking({
  run,
  leads,
  viewport,
  onMove,
}: {
  readonly run: Run;
  /** Approaches and departures, chosen by their named points. */
  readonly leads: readonly NamedLead[];
  readonly viewport: Viewport;
  readonly onMove: MovePointed | undefined;
}): { readonly hover: Hover; readonly over: (at: Place | null) => void; readonly tap: (at: Place) => void } {
  const [hover] = useState(createHover);
  return useMemo(() => {
    const found = (at: Place) => motionAt(run.plane, leads, toPlace(viewport.get(), at), NEAR / viewport.get().scale);
    return {
      hover,
      over: (at) => hover.set(at && (found(at)?.step ?? null)),
      tap(at) {
        const position = found(at);
        if (!position) return;
        hover.set(null);
        chooseMilled(run, position);
        onMove?.(position.step);
      },
    };
  }, [hover, run, leads, viewport, onMove]);
}
