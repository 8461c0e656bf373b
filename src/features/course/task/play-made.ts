import { playback } from "../../../app/calculation/playback.ts";
import { enlargePicture } from "../../../app/fields/dialog/help-dock.ts";
import { reducedMotion } from "../../../app/base/settings/appearance.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { RATES } from "../../../view/playback.ts";

/** Longest time that the run of a passed task plays, in seconds of the clock. */
const LASTS = 12;

/** Plays the run of the open work from its start, so fast that it soon ends; then the rate is as before. */
export function playMade(): void {
  // On a short phone the picture is a strip, or none, above the prompts.
  enlargePicture(true);
  const { rate, track } = playback.get();
  playback.dispatch({ do: "first" });
  const fast = RATES.find((each) => track.total / each <= LASTS) ?? RATES[RATES.length - 1] ?? rate;
  const used = Math.max(rate, fast);
  playback.dispatch({ do: "rate", rate: used });
  playback.dispatch({ do: "play" });
  const stop = playback.subscribe(() => {
    if (playback.get().playing) return;
    stop();
    if (playback.get().rate === used) playback.dispatch({ do: "rate", rate });
  });
}

/** Shows what was made: the run plays, or stands at its end with reduced motion. */
export function showMade(): void {
  if (reducedMotion(useSettings.getState())) playback.dispatch({ do: "last" });
  else playMade();
}
