import { useCallback } from "react";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { Readout } from "./Readout.tsx";
import { chipText, runningText } from "./running.ts";

/** Position, feed, spindle speed, phase, pass, chip and step of the manual of a turned moment. */
export function TurnedReadout({
  run,
  playback,
  chipAt,
}: {
  readonly run: Run;
  readonly playback: PlaybackStore;
  readonly chipAt: PlayedScene["chipAt"] | null;
}) {
  const texts = useTexts(),
    t = texts.lathe,
    lengths = useLengths();
  const moment = useCallback(() => {
    const position = playback.shown(),
      now = runningText(texts, lengths, run, position);
    return now && { ...now, chip: chipText(lengths, chipAt?.(position) ?? null, run.steps[position.step]?.move) };
  }, [texts, lengths, run, playback, chipAt]);
  const chip = Object.entries(t.chip)
    .map((each) => each.join(" "))
    .join(" · ");
  return (
    <Readout
      playback={playback}
      moment={moment}
      cells={[
        ["x", t.axisX],
        ["z", t.axisZ],
        ["feed", t.feedName],
        ["speed", t.speedName],
      ]}
    >
      <span data-says="phase" />
      <span data-says="pass" />
      <span className="number" data-says="chip" title={chip} />
      <span data-says="block" />
    </Readout>
  );
}

/** One sentence about the shown moment. */
export function statusText(
  texts: ReturnType<typeof useTexts>,
  lengths: Lengths,
  run: Run,
  playback: PlaybackStore,
): string {
  const now = runningText(texts, lengths, run, playback.shown()),
    t = texts.lathe;
  if (!now) return t.pictureEmpty;
  const { position } = playback.get();
  const where =
    position.step >= run.steps.length ? t.atEnd : position.step === 0 && position.fraction === 0 ? t.atStart : "";
  return [where, now.step, `${t.axisX} ${now.x}`, `${t.axisZ} ${now.z}`, now.feed, now.pass, now.block]
    .filter((part) => part !== "")
    .join(". ");
}
