import { useCallback, useEffect, useMemo, useRef } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { secondsAt, trackOf } from "../../../view/playback.ts";
import { timeBar, type TimedStep } from "../../../view/timeline.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { clockText } from "../../base/clock-text.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { glide } from "../../calculation/glide.ts";
import { useEachReading } from "./use-playback.ts";

/** Data of a timeline: a run, or the part of one that a view shows. */
export interface TimedRun extends Pick<Run, "operations"> {
  readonly steps: readonly (TimedStep & { readonly seconds: number })[];
}

/** Playhead updates per second. */
export const JERKS = 10;

/** Timeline of the whole run: cutting and rapids, boundaries of moves, names of operations. Dragging scrubs. */
export function Timeline({ run, playback }: { readonly run: TimedRun; readonly playback: PlaybackStore }) {
  const t = useTexts().lathe,
    language = useSettings((s) => s.language);
  const bar = useMemo(() => timeBar(run.steps, trackOf(run.steps)), [run]);
  const input = useRef<HTMLInputElement>(null),
    head = useRef<HTMLDivElement>(null),
    time = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    const at = (position: PlayPosition) => {
      const { track } = playback.get();
      return `translateX(${track.total > 0 ? (100 * secondsAt(track, position)) / track.total : 0}%)`;
    };
    return head.current ? glide(head.current, playback, { at, bends: () => [], jerks: JERKS }).end : undefined;
  }, [playback]);
  useEachReading(
    playback,
    useCallback(() => {
      const { track, position } = playback.get(),
        seconds = secondsAt(track, position);
      const [now, whole] = [clockText(language, seconds), clockText(language, track.total)];
      if (input.current) {
        input.current.value = String(track.total > 0 ? (1000 * seconds) / track.total : 0);
        input.current.setAttribute("aria-valuetext", t.timeOf(now, whole));
      }
      const text = `${now} / ${whole}`;
      if (time.current && time.current.textContent !== text) time.current.textContent = text;
    }, [playback, language, t]),
  );
  const marks = bar.boundaries.map((b) => `M${b * 1000} 0V1`).join("");
  return (
    <div className="lathe-timeline">
      <div className="lathe-timeline-names" aria-hidden="true">
        {bar.operations.map(({ operation, from, to }, i) => {
          const named = run.operations[operation];
          return (
            named && (
              <span
                key={i}
                style={{
                  left: `${from * 100}%`,
                  width: `max(0px, min(${(to - from) * 100}%, ${(1 - from) * 100}% - var(--clock)))`,
                }}
              >
                <b>{named.cycle}</b>
                <b>· T{named.tool.T}</b>
              </span>
            )
          );
        })}
      </div>
      <span ref={time} className="lathe-time number" aria-hidden="true" />
      <svg className="lathe-timebar" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
        <path className="rapid" d={bar.rapid} />
        <path className="cutting" d={bar.cutting} />
      </svg>
      <svg className="lathe-timemarks" viewBox="0 0 1000 1" preserveAspectRatio="none" aria-hidden="true">
        <path d={marks} />
      </svg>
      <div ref={head} className="lathe-playhead" aria-hidden="true" />
      <input
        ref={input}
        type="range"
        min={0}
        max={1000}
        step={0.01}
        defaultValue={0}
        aria-label={t.timeline}
        disabled={run.steps.length === 0}
        onInput={(event) =>
          playback.dispatch({
            do: "seekSeconds",
            seconds: (Number(event.currentTarget.value) / 1000) * playback.get().track.total,
          })
        }
      />
    </div>
  );
}
