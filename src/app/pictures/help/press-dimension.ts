import { useRef, type PointerEvent } from "react";

/** Dimensions are thin, so a click within these distances still counts, pixels, nearest first. */
const RINGS = [0, 4, 8, 12] as const;
const DIRECTIONS = 8;
/** A press longer than this takes the value instead of opening its prompt, ms. */
const LONG = 500;

interface At {
  readonly x: number;
  readonly y: number;
}

/** The parameter of the dimension at or near a place of the window; null if there is none. */
export function dimensionAt({ x, y }: At): string | null {
  for (const ring of RINGS) {
    for (let i = 0; i < (ring === 0 ? 1 : DIRECTIONS); i += 1) {
      const angle = (2 * Math.PI * i) / DIRECTIONS;
      const found = document
        .elementFromPoint(x + ring * Math.cos(angle), y + ring * Math.sin(angle))
        ?.closest<SVGElement>("[data-q]");
      if (found?.dataset["q"]) return found.dataset["q"];
    }
  }
  return null;
}

/** Listeners that tell a press from a long one; with Alt a press counts as long. */
export function usePressing(pressed: (at: At, long: boolean) => void) {
  const begun = useRef<number | null>(null);
  return {
    onPointerDown: (event: PointerEvent) => void (begun.current = event.timeStamp),
    onPointerUp(event: PointerEvent) {
      if (begun.current === null) return;
      const long = event.altKey || event.timeStamp - begun.current >= LONG;
      begun.current = null;
      pressed({ x: event.clientX, y: event.clientY }, long);
    },
    onPointerCancel: () => void (begun.current = null),
    onContextMenu: (event: { preventDefault: () => void }) => event.preventDefault(),
  };
}
