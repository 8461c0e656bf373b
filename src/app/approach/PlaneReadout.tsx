import { useCallback, useEffect, useRef, useState } from "react";
import type { Texts } from "../../i18n/index.ts";
import { formatNumber, formatPosition } from "../../i18n/number.ts";
import type { Language } from "../../i18n/languages.ts";
import type { ApproachRun, PlaneStep } from "../../program/plane-types.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { spotAt } from "../../view/approach/plane-scene.ts";
import { isRapid } from "../../kernel/mill-motion.ts";
import type { Clock } from "../clock.ts";
import type { PlaybackStore } from "../lathe/playback-store.ts";
import { useEachPicture, usePlayback } from "../lathe/use-playback.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";

/** What is said about a moment of a milling program. */
interface Moment {
  readonly x: string;
  readonly y: string;
  readonly z: string;
  readonly feed: string;
  readonly step: string;
  readonly block: string;
}

/** Position, feed, and what the motion is for; null in an empty run. */
export function momentText(
  t: Texts,
  language: Language,
  steps: readonly PlaneStep[],
  approaches: readonly ApproachRun[],
  position: PlayPosition,
): Moment | null {
  const motion = steps[Math.min(position.step, steps.length - 1)], at = spotAt(steps, position.step, position.fraction);
  if (!motion || !at) return null;
  const lead = approaches.find((a) => a.index === motion.index);
  const what = lead ? `${lead.departing ? "DEP" : "APPR"} ${lead.form}` : isRapid(motion) ? t.lathe.rapid : t.approach.feedMove;
  const unit = motion.feedUnit === "mm/rev" ? t.lathe.perTurn : t.lathe.perMinute;
  return {
    x: formatPosition(language, at.x),
    y: formatPosition(language, at.y),
    z: at.z === null ? "–" : formatPosition(language, at.z),
    feed: motion.feed === undefined ? t.lathe.rapid : `${formatNumber(language, motion.feed)} ${unit}`,
    step: what,
    block: t.lathe.block(String(motion.block)),
  };
}

/** Live position, feed and block; the numbers change without rendering. */
export function PlaneReadout({ steps, approaches, playback }: { readonly steps: readonly PlaneStep[];
  readonly approaches: readonly ApproachRun[]; readonly playback: PlaybackStore })
{
  const t = useTexts(), language = useSettings((s) => s.language);
  const group = useRef<HTMLDivElement>(null);
  useEachPicture(playback, useCallback(() => {
    const now = momentText(t, language, steps, approaches, playback.shown());
    for (const cell of group.current?.querySelectorAll<HTMLElement>("[data-says]") ?? []) {
      const said = now?.[cell.dataset["says"] as keyof Moment] ?? "–";
      if (cell.textContent !== said) cell.textContent = said;
    }
  }, [t, language, steps, approaches, playback]));
  const cells = [["x", "X"], ["y", "Y"], ["z", "Z"], ["feed", t.lathe.feedName]] as const;
  return (
    <div ref={group} className="lathe-readout" role="group" aria-label={t.lathe.now}>
      <dl className="number">
        {cells.map(([key, name]) => (
          <div key={key} className={`readout-${key === "y" ? "x" : key}`}>
            <dt>{name}</dt>
            <dd data-says={key} />
          </div>
        ))}
      </dl>
      <p className="lathe-step" data-says="step" />
      <p className="lathe-phase soft">
        <span data-says="block" />
      </p>
    </div>
  );
}

/** Least time between two sentences for a screen reader while it plays, ms. */
const PAUSE = 2500;

/** The moment in one sentence. */
export const momentSentence = (...given: Parameters<typeof momentText>): string => {
  const now = momentText(...given);
  return now ? [now.step, `X ${now.x}`, `Y ${now.y}`, `Z ${now.z}`, now.feed, now.block].join(". ") : given[0].lathe.pictureEmpty;
};

/** The same read out: at once when something was pressed, now and then while it plays. */
export function SpokenMoment({ steps, approaches, playback, clock }: { readonly steps: readonly PlaneStep[];
  readonly approaches: readonly ApproachRun[]; readonly playback: PlaybackStore; readonly clock: Clock })
{
  const t = useTexts(), language = useSettings((s) => s.language);
  const step = usePlayback(playback, (s) => s.get().position.step), playing = usePlayback(playback, (s) => s.get().playing);
  const [said, say] = useState("");
  const last = useRef(-PAUSE);
  useEffect(() => {
    if (playing && clock.now() - last.current < PAUSE) return;
    last.current = clock.now();
    say(momentSentence(t, language, steps, approaches, playback.shown()));
  }, [step, playing, t, language, steps, approaches, playback, clock]);
  return <p className="unseen" role="status">{said}</p>;
}
