import { useEffect, useState } from "react";
import type { Bounds } from "../../../view/camera.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useMeasuring, type MeasuringShown } from "../measure/measuring.ts";
import {
  useMeasureSource,
  type MeasurableRun,
  type MeasuredMove,
  type MeasuredStock,
  type MeasureSource,
} from "../measure/source.ts";
import { sectionProjection, type Sight } from "./place-projection.ts";
import { usePicking, type MovePointed, type Pickable, type Picking } from "./use-picking.ts";
import { createViewport, type Viewport } from "./viewport.ts";

/** What the pointer does in the plane of a view: it chooses moves, or measures. */
export interface PlanePicking extends Picking {
  readonly viewport: Viewport;
  readonly measuring: MeasuringShown;
}

/** A plane of the machine in a view: its camera, what can be picked in it, and what can be measured. */
export function useFlatScene({
  xUp,
  bounds,
  pickable,
  onMove,
  measurable,
  moves,
  stock,
  playback,
}: {
  readonly xUp: boolean;
  /** Shown as long as nobody moves the picture. */
  readonly bounds: Bounds;
  readonly pickable: Pickable;
  readonly onMove: MovePointed | undefined;
  readonly measurable: MeasurableRun;
  readonly moves: readonly MeasuredMove[];
  readonly stock: MeasuredStock | null;
  readonly playback: PlaybackStore;
}): { readonly sight: Sight; readonly measured: MeasureSource; readonly picking: PlanePicking } {
  const [viewport] = useState(() => createViewport(xUp));
  const measuring = useMeasuring(),
    measured = useMeasureSource(measurable, moves, stock, playback);
  const picking = usePicking(viewport, pickable, onMove);
  useEffect(() => viewport.setBounds(bounds), [bounds, viewport]);
  useEffect(() => viewport.setXUp(xUp), [xUp, viewport]);
  return { sight: sectionProjection(viewport), measured, picking: { ...picking, viewport, measuring } };
}
