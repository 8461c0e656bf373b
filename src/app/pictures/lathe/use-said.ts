import { useCallback, useEffect, useRef, useState, type RefObject } from "react";
import type { Clock } from "../../base/clock.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useEachReading } from "./use-playback.ts";

/** What stands in an element with one text, without a new node for each text. */
function write(element: Element, text: string): void {
  const { firstChild } = element;
  if (firstChild instanceof Text) firstChild.data = text;
  else element.textContent = text;
}

/**
 * Writes what is said about the moment into the elements of a group, each by its `data-says`, without rendering and
 * only where it changes. `textOf` gives the text of one of them for the moment that is shown.
 */
export function useSaid<T>(
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

/** Least time between two sentences for a screen reader while it plays, ms. */
const PAUSE = 2500;

/**
 * A sentence about the moment, to be read out: a new one at once when something was pressed, now and then while it
 * plays.
 */
export function useSpoken(playback: PlaybackStore, clock: Clock, sentence: () => string): string {
  const [said, say] = useState("");
  const last = useRef(-PAUSE);
  useEffect(() => {
    let told: { readonly step: number; readonly playing: boolean } | null = null;
    const tell = () => {
      const {
        position: { step },
        playing,
      } = playback.get();
      if (told?.step === step && told.playing === playing) return;
      if (playing && clock.now() - last.current < PAUSE) return;
      told = { step, playing };
      last.current = clock.now();
      say(sentence());
    };
    tell();
    return playback.subscribeReader(tell);
  }, [playback, clock, sentence]);
  return said;
}
