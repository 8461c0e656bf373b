import { useState, type PointerEvent } from "react";
import { planePoint, type PlanePoint } from "../../../kernel/plane/plane.ts";
import { placeIn } from "../../base/unit.ts";
import { toPlace, type Camera } from "../../../view/camera.ts";
import type { Handle } from "../../../view/approach/drag.ts";

/** Dragging the handles of a drawing. */
export interface Dragging {
  /** The camera during a drag, so that the picture does not move. */
  readonly camera: Camera | null;
  readonly handle: Handle | null;
  readonly begin: (handle: Handle, camera: Camera, event: PointerEvent<SVGElement>) => void;
  readonly move: (event: PointerEvent<SVGElement>) => void;
  readonly end: (event: PointerEvent<SVGElement>) => void;
}

/** Follows a pointer that drags a handle; `onMove` gets the place in the working plane. */
export function useDrag(onMove: (handle: Handle, to: PlanePoint, camera: Camera) => void): Dragging {
  const [held, hold] = useState<{ readonly handle: Handle; readonly camera: Camera } | null>(null);
  return {
    camera: held?.camera ?? null,
    handle: held?.handle ?? null,
    begin(handle, camera, event) {
      if (event.button !== 0) return;
      event.preventDefault();
      event.currentTarget.setPointerCapture(event.pointerId);
      hold({ handle, camera });
    },
    move(event) {
      const picture = event.currentTarget.ownerDocument.defaultView && event.currentTarget.closest("svg");
      if (!held || !picture) return;
      onMove(held.handle, planePoint(toPlace(held.camera, placeIn(picture, event))), held.camera);
    },
    end: () => hold(null),
  };
}

/** Grid of a dragged value: as fine as the picture can show, mm. */
export function gridOf(camera: Camera): number {
  return [0.01, 0.05, 0.1, 0.5, 1, 5, 10].find((grid) => grid * camera.scale >= 3) ?? 10;
}
