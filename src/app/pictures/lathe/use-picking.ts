import { useMemo, useState } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { toPlace, type Place } from "../../../view/camera.ts";
import { createHover, type Hover } from "./Chosen.tsx";
import type { PointerActions } from "./gestures.ts";
import type { Viewport } from "./viewport.ts";

/** A move was chosen. `byKey`: by keyboard, so its dialog gets the focus; returns whether it does. */
export type MovePointed = (step: number, byKey?: boolean) => boolean;

/** Distance at which a pointer picks, pixels. */
const NEAR = 10;

/** What can be picked in the plane of a scene. Places in the part, distances in mm. */
export interface Pickable {
  /** The moment of the move at a place; null if none is within `reach`. */
  readonly find: (place: Pt, reach: number) => PlayPosition | null;
  /** Chooses a moment, pointed at with a place, or by keyboard. */
  readonly choose: (position: PlayPosition, place?: Pt, reach?: number) => void;
  /** Takes a click on a place for something else; true if it did. */
  readonly point?: (place: Pt) => boolean;
}

/** Choosing in a picture: a click takes the tool to the move under it, hovering shows which one that would be. */
export interface Picking extends Pick<Pickable, "choose"> {
  readonly hover: Hover;
  readonly pointer: PointerActions;
  /** Called with the index of a clicked move, after the tool went there. */
  readonly onMove: MovePointed | undefined;
}

/** The pointer of a view picks in its scene. */
export function usePicking(viewport: Viewport, pickable: Pickable, onMove: MovePointed | undefined): Picking {
  const [hover] = useState(createHover);
  return useMemo(() => {
    const reach = () => NEAR / viewport.get().scale,
      placeAt = (at: Place) => toPlace(viewport.get(), at);
    const { find, choose, point } = pickable;
    return {
      hover,
      choose,
      onMove,
      pointer: {
        hover: (at) => hover.set(at && (find(placeAt(at), reach())?.step ?? null)),
        tap(at) {
          const place = placeAt(at);
          if (point?.(place)) return;
          const position = find(place, reach());
          if (!position) return;
          hover.set(null);
          choose(position, place, reach());
          onMove?.(position.step);
        },
      },
    };
  }, [hover, viewport, pickable, onMove]);
}
