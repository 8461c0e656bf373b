import { useCallback } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { Clock } from "../../base/clock.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { chipText, runningText, type Running } from "./running.ts";
import { LiveSentence } from "./LiveSentence.tsx";
import { useMomentTexts } from "./use-moment-texts.ts";

const FIELDS = ["x", "z", "feed", "speed"] as const;

/** The moment in words, and its chip. */
interface Said extends Running {
  readonly chip: string;
}

const textOfCell = (now: Said | null, says: string): string | null => now?.[says as keyof Said] ?? null;

/** Live position, feed, spindle speed, phase, pass and step of the manual; updated without rendering. */
export function Readout({
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
  const moment = useCallback((): Said | null => {
    const position = playback.shown(),
      now = runningText(texts, lengths, run, position);
    return now && { ...now, chip: chipText(lengths, chipAt?.(position) ?? null, run.steps[position.step]?.move) };
  }, [texts, lengths, run, playback, chipAt]);
  const group = useMomentTexts(playback, moment, textOfCell);
  const names = { x: t.axisX, z: t.axisZ, feed: t.feedName, speed: t.speedName };
  return (
    <div ref={group} className="lathe-readout" data-counts={lengths.unit} role="group" aria-label={t.now}>
      <dl className="number">
        {FIELDS.map((key) => (
          <div key={key} className={`readout-${key}`}>
            <dt>{names[key]}</dt>
            <dd data-says={key} />
          </div>
        ))}
      </dl>
      <p className="lathe-step" data-says="step" />
      <p className="lathe-phase soft">
        <span data-says="phase" />
        <span data-says="pass" />
        <span
          className="number"
          data-says="chip"
          title={Object.entries(t.chip)
            .map((each) => each.join(" "))
            .join(" · ")}
        />
        <span data-says="block" />
      </p>
    </div>
  );
}

/** The same in a sentence for screen readers. */
export function SpokenStatus({
  run,
  playback,
  clock,
}: {
  readonly run: Run;
  readonly playback: PlaybackStore;
  readonly clock: Clock;
}) {
  const texts = useTexts(),
    lengths = useLengths();
  const sentence = useCallback(() => statusText(texts, lengths, run, playback), [texts, lengths, run, playback]);
  return <LiveSentence playback={playback} clock={clock} sentence={sentence} />;
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
