import { useCallback, useRef } from "react";
import { formatNumber, formatFixed } from "../../i18n/number.ts";
import { RATES, secondsAt } from "../../view/playback.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { GlyphButton } from "./GlyphButton.tsx";
import type { PlaybackStore } from "./playback-store.ts";
import { useEachPicture, usePlayback } from "./use-playback.ts";

/** Minutes and seconds as on a stop-watch: 1:04.3. */
export function clockText(language: Parameters<typeof formatFixed>[0], seconds: number): string {
  const tenths = Math.round(seconds * 10), minutes = Math.floor(tenths / 600), rest = (tenths - minutes * 600) / 10;
  return `${minutes}:${rest < 10 ? "0" : ""}${formatFixed(language, rest, 1)}`;
}

/** Play, pause, move by move, to the ends, and how fast. */
export function PlaybackBar({ playback }: { readonly playback: PlaybackStore }) {
  const t = useTexts().lathe, language = useSettings(s => s.language);
  const playing = usePlayback(playback, s => s.get().playing), rate = usePlayback(playback, s => s.get().rate);
  const empty = usePlayback(playback, s => s.get().track.ends.length === 0);
  const first = usePlayback(playback, s => s.get().position.step === 0 && s.get().position.fraction === 0);
  const last = usePlayback(playback, s => s.get().position.step >= s.get().track.ends.length);
  const time = useRef<HTMLSpanElement>(null);
  useEachPicture(playback, useCallback(() => {
    const { track, position } = playback.get();
    if (time.current) time.current.textContent = `${clockText(language, secondsAt(track, position))} / ${clockText(language, track.total)}`;
  }, [playback, language]));
  return (
    <div className="lathe-playbar" role="toolbar" aria-label={t.playback}>
      <GlyphButton glyph="first" name={t.first} disabled={empty || first} onPress={() => playback.dispatch({ do: "first" })} />
      <GlyphButton glyph="back" name={t.back} disabled={empty || first} onPress={() => playback.dispatch({ do: "back" })} />
      <GlyphButton glyph={playing ? "pause" : "play"} name={playing ? t.pause : t.play} disabled={empty} onPress={() => playback.dispatch({ do: "toggle" })} />
      <GlyphButton glyph="forward" name={t.forward} disabled={empty || last} onPress={() => playback.dispatch({ do: "forward" })} />
      <GlyphButton glyph="last" name={t.last} disabled={empty || last} onPress={() => playback.dispatch({ do: "last" })} />
      <label className="lathe-rate">
        <span className="unseen">{t.speed}</span>
        <select className="select number" value={rate} onChange={event => playback.dispatch({ do: "rate", rate: Number(event.target.value) })}>
          {RATES.map(each => <option key={each} value={each}>{formatNumber(language, each)}×</option>)}
        </select>
      </label>
      <span ref={time} className="lathe-time number" aria-hidden="true" />
    </div>
  );
}
