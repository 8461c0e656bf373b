import { useMemo, useRef, type MouseEvent, type PointerEvent } from "react";
import type { Pt } from "../../kernel/geometry/point.ts";
import { at } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { toPlace } from "../../view/camera.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { placeIn } from "../../app/base/unit.ts";
import { boundsRound } from "../../app/findings/spots.ts";
import type { PicturePlace } from "../../app/pictures/lathe/places.ts";
import type { Viewport } from "../../app/pictures/lathe/viewport.ts";

/** A pointer that moved further is panning, px. */
const STILL = 6;

/** A press on a picture, as a place of the part. */
export function usePress(viewport: Viewport, onPress: ((place: Pt) => void) | null) {
  const from = useRef({ x: 0, y: 0 });
  return {
    begin({ clientX, clientY }: PointerEvent) {
      from.current = { x: clientX, y: clientY };
    },
    end(event: MouseEvent) {
      const { clientX, clientY, currentTarget, target } = event;
      const isMoved = Math.hypot(clientX - from.current.x, clientY - from.current.y) > STILL;
      if (!onPress || isMoved || (target instanceof Element && target.closest("button"))) return;
      const { z, r } = toPlace(viewport.get(), placeIn(currentTarget, event));
      onPress(at(axial(z), radius(r)));
    },
  };
}

const NOTHING: readonly PicturePlace[] = [];

/** The pressed place as a mark in the picture. */
export function usePressedPlace(place: Pt | null): readonly PicturePlace[] {
  const line = useTexts("course").question.yours;
  return useMemo(
    () =>
      place
        ? [
            {
              id: "pressed",
              kind: "told",
              mark: "?",
              place,
              bounds: boundsRound([], place),
              line,
              position: { step: 0, fraction: 0 },
              issue: null,
            },
          ]
        : NOTHING,
    [place, line],
  );
}
