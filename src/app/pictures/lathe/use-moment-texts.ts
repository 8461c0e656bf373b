import { useCallback, useRef, type RefObject } from "react";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useEachReading } from "./use-playback.ts";

/** Writes the text of an element, without a new node for each text. */
function write(element: Element, text: string): void {
  const { firstChild } = element;
  if (firstChild instanceof Text) firstChild.data = text;
  else element.textContent = text;
}

/**
 * Writes texts about the moment into the elements of a group, each by its `data-says`, without rendering and only where
 * they change. `textOf`: text of one element for the shown moment.
 */
export function useMomentTexts<T>(
  playback: PlaybackStore,
  moment: () => T,
  textOf: (moment: T, says: string) => string | null,
): RefObject<HTMLDivElement | null> {
  const group = useRef<HTMLDivElement>(null),
    said = useRef(new WeakMap<Element, string>());
  useEachReading(
    playback,
    useCallback(() => {
      const now = moment();
      for (const cell of group.current?.querySelectorAll<HTMLElement>("[data-says]") ?? []) {
        const text = textOf(now, cell.dataset["says"] ?? "") ?? (cell.localName === "dd" ? "–" : "");
        if (said.current.get(cell) === text) continue;
        write(cell, text);
        said.current.set(cell, text);
      }
    }, [moment, textOf]),
  );
  return group;
}
