import { useMemo } from "react";
import type { Texts } from "../../../i18n/index.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { ApproachRun, PlaneStep } from "../../../program/tools/plane-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { spotAt } from "../../../view/approach/plane-scene.ts";
import { isRapid } from "../../../kernel/plane/mill-motion.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import type { MomentWords } from "../lathe/Readout.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Texts about a moment of a milling program. */
type Moment = Readonly<Record<"x" | "y" | "z" | "feed" | "step" | "block", string>>;

/** Position, feed and purpose of the motion; null in an empty run. */
function momentText(
  t: Texts,
  lengths: Lengths,
  steps: readonly PlaneStep[],
  approaches: readonly ApproachRun[],
  position: PlayPosition,
): Moment | null {
  const motion = steps[Math.min(position.step, steps.length - 1)],
    at = spotAt(steps, position.step, position.fraction);
  if (!motion || !at) return null;
  const lead = approaches.find((a) => a.index === motion.index);
  const what = lead
    ? `${lead.departing ? "DEP" : "APPR"} ${lead.form}`
    : isRapid(motion)
      ? t.lathe.rapid
      : t.approach.feedMove;
  const unit = motion.feedUnit === "mm/rev" ? t.lathe.perTurn : t.lathe.perMinute;
  return {
    x: lengths.position(at.x),
    y: lengths.position(at.y),
    z: at.z === null ? "–" : lengths.position(at.z),
    feed: motion.feed === undefined ? t.lathe.rapid : `${lengths.number(motion.feed)} ${lengths.words(unit)}`,
    step: what,
    block: t.lathe.block(String(motion.block)),
  };
}

/** Position, feed, purpose and block of a milled moment. */
export function useMilledWords(
  steps: readonly PlaneStep[],
  approaches: readonly ApproachRun[],
  lengths: Lengths,
  playback: PlaybackStore,
): MomentWords {
  const t = useTexts();
  return useMemo(() => {
    const texts = () => momentText(t, lengths, steps, approaches, playback.shown());
    return {
      cells: [
        ["x", "X"],
        ["y", "Y", "x"],
        ["z", "Z"],
        ["feed", t.lathe.feedName],
      ],
      notes: [["block"]],
      texts,
      sentence() {
        const now = texts();
        return now
          ? [now.step, `X ${now.x}`, `Y ${now.y}`, `Z ${now.z}`, now.feed, now.block].join(". ")
          : t.lathe.pictureEmpty;
      },
    };
  }, [t, lengths, steps, approaches, playback]);
}
