import { Toolbar } from "react-aria-components/Toolbar";
import { formatNumber } from "../../../i18n/number.ts";
import { RATES } from "../../../view/playback.ts";
import { useActions } from "../../base/actions.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { GlyphButton } from "./GlyphButton.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { usePlayback } from "./use-playback.ts";

/** Play, pause, move by move, to the ends, and how fast. */
export function PlaybackBar({
  playback,
  children,
}: {
  readonly playback: PlaybackStore;
  readonly children: React.ReactNode;
}) {
  const t = useTexts().lathe,
    language = useSettings((s) => s.language);
  const playing = usePlayback(playback, (s) => s.get().playing),
    rate = usePlayback(playback, (s) => s.get().rate);
  const empty = usePlayback(playback, (s) => s.get().track.ends.length === 0);
  const first = usePlayback(playback, (s) => s.get().position.step === 0 && s.get().position.fraction === 0);
  const last = usePlayback(playback, (s) => s.get().position.step >= s.get().track.ends.length);
  const toggle = () => playback.dispatch({ do: "toggle" });
  useActions(empty ? [] : [{ id: "do.play", name: playing ? t.pause : t.play, run: toggle }]);
  return (
    <Toolbar className="lathe-playbar" aria-label={t.playback}>
      <GlyphButton
        glyph="first"
        name={t.first}
        disabled={empty || first}
        onPress={() => playback.dispatch({ do: "first" })}
      />
      <GlyphButton
        glyph="back"
        name={t.back}
        disabled={empty || first}
        onPress={() => playback.dispatch({ do: "back" })}
      />
      <GlyphButton
        glyph={playing ? "pause" : "play"}
        name={playing ? t.pause : t.play}
        disabled={empty}
        onPress={toggle}
      />
      <GlyphButton
        glyph="forward"
        name={t.forward}
        disabled={empty || last}
        onPress={() => playback.dispatch({ do: "forward" })}
      />
      <GlyphButton
        glyph="last"
        name={t.last}
        disabled={empty || last}
        onPress={() => playback.dispatch({ do: "last" })}
      />
      <label className="lathe-rate">
        <span className="unseen">{t.speed}</span>
        <select
          className="select number"
          value={rate}
          onChange={(event) => playback.dispatch({ do: "rate", rate: Number(event.target.value) })}
        >
          {RATES.map((each) => (
            <option key={each} value={each}>
              {formatNumber(language, each)}×
            </option>
          ))}
        </select>
      </label>
      {children}
    </Toolbar>
  );
}
