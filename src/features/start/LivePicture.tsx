import { readJson } from "../../program/files/bounded.ts";
import { useEffect, useMemo, useState } from "react";
import { clock } from "../../app/base/clock.ts";
import { reducedMotion } from "../../app/base/settings/appearance.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { CountedIn } from "../../app/calculation/lengths.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { createPlaybackStore } from "../../app/calculation/playback-store.ts";
import { runWithShippedTools } from "../../app/calculation/shipped-run.ts";
import { Picture } from "../../app/pictures/lathe/Picture.tsx";
import { useMaterial } from "../../app/pictures/lathe/use-material.ts";
import { stretchesOf, useShownPath } from "../../app/pictures/lathe/use-paths.ts";
import { usePlayback } from "../../app/pictures/lathe/use-playback.ts";
import { useViewportSize } from "../../app/pictures/lathe/use-viewport-size.ts";
import { createViewport } from "../../app/pictures/lathe/viewport.ts";
import { sceneOf } from "../../view/scene.ts";
import { trackOf } from "../../view/playback.ts";
import type { HeroProgram } from "./pictures.ts";
import { runningPass, type RunningPass } from "./running-pass.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";

/** Duration of the whole run on the screen, seconds. */
const LASTS = 70;
/** Pause on the finished part before the run repeats, ms. */
const END_PAUSE = 3000;

interface Props {
  readonly hero: HeroProgram;
  readonly plays: boolean;
  readonly name: string;
  /** Called when another pass or cycle begins, and when the picture is there. */
  readonly onRunning: (now: RunningPass) => void;
}

async function runProgram(): Promise<Outcome | null> {
  const { text } = await import("virtual:start-pictures/program");
  return runWithShippedTools(text);
}

/** The lathe view of the hero, once the worker has run its program. */
export function LivePicture(props: Props) {
  const [outcome, take] = useState<Outcome | null>(null);
  // Without an answer the still picture stays.
  useEffect(() => takeAnswer(() => runProgram().catch(() => null), take), []);
  return outcome && <RunningLathe {...props} outcome={outcome} />;
}

/** Plays a run again and again on the lathe view, with the path of the running operation. */
function RunningLathe({ hero, plays, name, onRunning, outcome }: Props & { readonly outcome: Outcome }) {
  const xDown = useSettings((s) => s.xDown);
  const still = useSettings(reducedMotion);
  const [viewport] = useState(() => createViewport(!xDown));
  const [playback] = useState(() => createPlaybackStore(clock));
  const stage = useViewportSize(viewport);
  const { run } = outcome;
  const { moving } = useMaterial(outcome, playback);
  const passes = stretchesOf(run);
  const path = useShownPath(run, passes.stretches, playback, "operation");
  const scene = useMemo(
    () =>
      sceneOf({
        blank: run.blank,
        clamping: run.clamping,
        contours: run.operations.map((o) => o.plan.contour),
        steps: run.steps,
        path: passes.whole,
      }),
    [run, passes],
  );
  useEffect(() => {
    viewport.setBounds(hero.frame);
    viewport.fit();
  }, [viewport, hero.frame]);
  useEffect(() => {
    const track = trackOf(run.steps);
    playback.dispatch({ do: "load", track });
    playback.dispatch({ do: "rate", rate: track.total / LASTS });
    playback.dispatch({ do: "seek", position: hero.at });
  }, [playback, run, hero.at]);
  useEffect(() => playback.setStill(still), [playback, still]);
  const ended = usePlayback(playback, (s) => s.get().position.step >= run.steps.length);
  useEffect(() => {
    playback.dispatch({ do: plays && !ended ? "play" : "pause" });
    if (!plays || !ended) return undefined;
    const again = setTimeout(() => playback.dispatch({ do: "play" }), END_PAUSE);
    return () => clearTimeout(again);
  }, [playback, plays, ended]);
  useEffect(() => () => playback.dispatch({ do: "pause" }), [playback]);

  const now = usePlayback(playback, (s) => JSON.stringify(runningPass(run, s.get().position.step)));
  useEffect(() => onRunning(readJson(now) as RunningPass), [now, onRunning]);
  return (
    <CountedIn value={run.program.unit}>
      <div ref={stage} className={`lathe-stage${ended ? " ended" : ""}`}>
        <Picture
          viewport={viewport}
          scene={scene}
          moving={moving}
          waiting={null}
          gouges={[]}
          residual={[]}
          section="half"
          name={name}
          path={path.stretches}
        />
      </div>
    </CountedIn>
  );
}
