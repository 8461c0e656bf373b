import { useCallback, useMemo } from "react";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import type { MomentWords } from "./Readout.tsx";
import { chipText, runningText } from "./running.ts";

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

/** Position, feed, spindle speed, phase, pass, chip and step of the manual of a turned moment. */
export function useTurnedWords(
  run: Run,
  lengths: Lengths,
  playback: PlaybackStore,
  chipAt: PlayedScene["chipAt"] | null,
): MomentWords {
  const all = useTexts(),
    t = all.lathe;
  const sentence = useCallback(() => statusText(all, lengths, run, playback), [all, lengths, run, playback]);
  return useMemo(
    () => ({
      cells: [
        ["x", t.axisX],
        ["z", t.axisZ],
        ["feed", t.feedName],
        ["speed", t.speedName],
      ],
      notes: [
        ["phase"],
        ["pass"],
        [
          "chip",
          {
            className: "number",
            title: Object.entries(t.chip)
              .map((each) => each.join(" "))
              .join(" · "),
          },
        ],
        ["block"],
      ],
      texts() {
        const position = playback.shown(),
          now = runningText(all, lengths, run, position);
        return now && { ...now, chip: chipText(lengths, chipAt?.(position) ?? null, run.steps[position.step]?.move) };
      },
      sentence,
    }),
    [all, t, lengths, run, playback, chipAt, sentence],
  );
}
