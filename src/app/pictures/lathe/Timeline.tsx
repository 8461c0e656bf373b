import { useCallback, useEffect, useMemo, useRef, useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { secondsAt, trackOf } from "../../../view/playback.ts";
import { operationAt, timeBar, toolTones, type TimedStep } from "../../../view/timeline.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { durationText } from "../../base/clock-text.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { glide } from "../../calculation/glide.ts";
import { useEachReading, useReadPlayback } from "./use-playback.ts";

/** Data of a timeline: a run, or the part of one that a view shows. */
export interface TimedRun extends Pick<Run, "operations"> {
  readonly steps: readonly (TimedStep & { readonly seconds: number })[];
}

/** Playhead updates per second. */
export const JERKS = 10;

/** Timeline of the whole run: cutting and rapids, boundaries of moves, numbers of operations. Dragging scrubs. */
export function Timeline({ run, playback }: { readonly run: TimedRun; readonly playback: PlaybackStore }) {
  const {
      lathe: t,
      page: {
        effect: { duration },
      },
    } = useTexts(),
    language = useSettings((s) => s.language);
  const bar = useMemo(() => timeBar(run.steps, trackOf(run.steps)), [run]);
  const tones = useMemo(() => toolTones(run.operations.map(({ tool }) => tool.T)), [run]);
  const input = useRef<HTMLInputElement>(null),
    head = useRef<HTMLDivElement>(null),
    time = useRef<HTMLSpanElement>(null);
  const running = useReadPlayback(playback, (store) => run.steps[store.get().position.step]?.operation ?? null);
  const [pointed, point] = useState<number | null>(null);
  const named = run.operations[pointed ?? running ?? -1];
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
      const [now, whole] = [durationText(duration, language, seconds), durationText(duration, language, track.total)];
      if (input.current) {
        const here = run.operations[run.steps[position.step]?.operation ?? -1];
        const at = t.timeOf(now, whole);
        input.current.value = String(track.total > 0 ? (1000 * seconds) / track.total : 0);
        input.current.setAttribute(
          "aria-valuetext",
          here ? `${at}, ${t.operation(String(here.cycle), String(here.tool.T))}` : at,
        );
      }
      const text = `${now} / ${whole}`;
      if (time.current && time.current.textContent !== text) time.current.textContent = text;
    }, [playback, run, language, duration, t]),
  );
  const marks = bar.boundaries.map((b) => `M${b * 1000} 0V1`).join("");
  return (
    <div className="lathe-timeline">
      <div className="lathe-timeline-bar">
        <div className="lathe-timeline-names" aria-hidden="true">
          {bar.operations.map(({ operation, from, to }, i) => (
            <span
              key={i}
              className={`tool-tone-${tones[operation] ?? 0}`}
              data-running={operation === (pointed ?? running)}
              style={{ left: `${from * 100}%`, width: `${(to - from) * 100}%` }}
            >
              <b>{operation + 1}</b>
            </span>
          ))}
        </div>
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
          onPointerMove={({ clientX, currentTarget }) => {
            const { left, width } = currentTarget.getBoundingClientRect();
            point(width > 0 ? operationAt(bar, (clientX - left) / width) : null);
          }}
          onPointerLeave={() => point(null)}
          onInput={(event) =>
            playback.dispatch({
              do: "seekSeconds",
              seconds: (Number(event.currentTarget.value) / 1000) * playback.get().track.total,
            })
          }
        />
      </div>
      <p className="lathe-time number" aria-hidden="true">
        <span ref={time} />
        {run.operations.length > 0 && (
          <span className="lathe-named">
            {named && (
              <>
                <b className={`tool-tone-${tones[run.operations.indexOf(named)] ?? 0}`}>
                  {run.operations.indexOf(named) + 1}
                </b>{" "}
                {named.cycle} · T{named.tool.T} {named.tool.NAME}
              </>
            )}
          </span>
        )}
      </p>
    </div>
  );
}
