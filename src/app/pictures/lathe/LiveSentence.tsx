import { useEffect, useRef, useState } from "react";
import type { Clock } from "../../base/clock.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** Shortest time between two sentences for a screen reader during playback, ms. */
const PAUSE = 2500;

/**
 * A sentence about the moment for screen readers, at the end of the view of the picture: at once after an input in this
 * view, now and then during playback. The moment also follows the cursor in the text and each new run: that is not
 * announced.
 */
export function LiveSentence({
  playback,
  clock,
  sentence,
}: {
  readonly playback: PlaybackStore;
  readonly clock: Clock;
  readonly sentence: () => string;
}) {
  const [said, say] = useState("");
  const place = useRef<HTMLParagraphElement>(null);
  const last = useRef(-PAUSE);
  useEffect(() => {
    const moment = () => {
      const { position, playing } = playback.get();
      return { step: position.step, playing };
    };
    let told = moment();
    return playback.subscribeReader(() => {
      const now = moment();
      if (told.step === now.step && told.playing === now.playing) return;
      if (now.playing && clock.now() - last.current < PAUSE) return;
      const view = place.current?.closest("section");
      const isHeard = now.playing || told.playing || view?.contains(document.activeElement);
      told = now;
      if (!isHeard) return;
      last.current = clock.now();
      say(sentence());
    });
  }, [playback, clock, sentence]);
  return (
    <p ref={place} className="unseen" role="status">
      {said}
    </p>
  );
}
