import { useCallback, useMemo, useRef } from "react";
import { blocksOfLines } from "../../course/task-start.ts";
import { durationText } from "../../app/base/clock-text.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { GlyphButton } from "../../app/pictures/lathe/GlyphButton.tsx";
import type { PlaybackStore } from "../../app/calculation/playback-store.ts";
import { runningText } from "../../app/pictures/lathe/running.ts";
import { useEachReading, usePlayback } from "../../app/pictures/lathe/use-playback.ts";
import type { Run } from "../../program/state/run-types.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { PlaybackRange } from "./use-playback-range.ts";

/** Steps of the time slider. */
const PARTS = 1000;

/** Play and pause, move by move, seek; the current block, and the step of the manual. */
export function LessonBar({
  playback,
  stretch,
  run,
  lines,
}: {
  readonly playback: PlaybackStore;
  readonly stretch: PlaybackRange;
  readonly run: Run;
  /** The current program. */
  readonly lines: readonly string[];
}) {
  const t = useTexts("course").picture;
  const texts = useTexts();
  const lengths = useLengths(run),
    { language } = lengths;
  const playing = usePlayback(playback, (s) => s.get().playing);
  const { duration } = texts.page.effect;
  const input = useRef<HTMLInputElement>(null);
  const said = useRef<HTMLSpanElement>(null);
  const block = useRef<HTMLSpanElement>(null);
  const blocks = useMemo(() => blocksOfLines(lines), [lines]);
  const { now, length } = stretch;
  useEachReading(
    playback,
    useCallback(() => {
      if (input.current) {
        input.current.value = String(length > 0 ? (PARTS * now()) / length : 0);
        input.current.setAttribute(
          "aria-valuetext",
          texts.lathe.timeOf(durationText(duration, language, now()), durationText(duration, language, length)),
        );
      }
      const position = playback.shown();
      const isCalled = (run.steps[position.step]?.operation ?? null) !== null;
      const running = isCalled ? runningText(texts, lengths, run, position) : null;
      const text = running ? [running.pass, running.step].filter((each) => each !== "").join(" · ") : "";
      if (said.current && said.current.textContent !== text) said.current.textContent = text;
      const step = run.steps[Math.min(position.step, run.steps.length - 1)];
      const line = (step && blocks[step.block]?.split("\n")[0]) ?? "";
      if (block.current && block.current.textContent !== line) block.current.textContent = line;
      // oxlint-disable-next-line react/exhaustive-deps -- `now` is new in each render and reads the same playback
    }, [playback, length, texts, lengths, language, duration, run, blocks]),
  );
  return (
    <div className="lesson-bar">
      <div className="lesson-play">
        <GlyphButton glyph="first" name={t.first} onPress={stretch.restart} />
        <GlyphButton glyph={playing ? "pause" : "play"} name={playing ? t.pause : t.play} onPress={stretch.toggle} />
        <GlyphButton glyph="forward" name={t.forward} onPress={() => playback.dispatch({ do: "forward" })} />
        <input
          ref={input}
          type="range"
          min={0}
          max={PARTS}
          step="any"
          defaultValue={0}
          aria-label={t.scrub}
          onInput={(event) => stretch.seek((Number(event.currentTarget.value) / PARTS) * length)}
        />
      </div>
      <p className="lesson-step small">
        <span ref={block} className="number" /> <span ref={said} />
      </p>
    </div>
  );
}
