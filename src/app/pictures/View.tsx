import { Fragment, useEffect, useId, useState, type ReactNode } from "react";
import { trackOf } from "../../view/playback.ts";
import { reducedMotion } from "../base/settings/appearance.ts";
import { useSettings } from "../base/settings/settings.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { DeferredUntilPaint } from "../base/typing.ts";
import type { Clock } from "../base/clock.ts";
import { CountedIn } from "../calculation/lengths.ts";
import type { PlaybackStore } from "../calculation/playback-store.ts";
import { useEditor } from "../document/store.ts";
import { KEEPS_KEYBOARD } from "../place/place.ts";
import type { Run } from "../../program/state/run-types.ts";
import { GlyphButton } from "./lathe/GlyphButton.tsx";
import { pressKey } from "./lathe/keys.ts";
import { LiveSentence } from "./lathe/LiveSentence.tsx";
import { Outdated } from "./lathe/Outdated.tsx";
import { PlaceButtons } from "./lathe/PlaceButtons.tsx";
import type { Sight } from "./lathe/place-projection.ts";
import type { PicturePlace } from "./lathe/places.ts";
import { PlaybackBar } from "./lathe/PlaybackBar.tsx";
import { Readout, type MomentWords } from "./lathe/Readout.tsx";
import { Timeline, type TimedRun } from "./lathe/Timeline.tsx";
import type { PlanePicking } from "./lathe/use-flat-scene.ts";
import { useStage } from "./lathe/use-stage.ts";
import { ViewBar, type BarTools } from "./lathe/ViewBar.tsx";
import { MeasuredInSection, Measurements } from "./measure/Measurements.tsx";
import type { MeasureSource } from "./measure/source.ts";
import "./lathe/lathe.css";

/** One way to see a run: the section of the lathe, the working plane of a mill, or the body in space. */
export interface Scene<Seen extends Sight | null = Sight> {
  /** Names it among those of its view, which has the class of the first one: `plane-view`. */
  readonly name: string;
  readonly title: string;
  readonly unit: Run["program"]["unit"];
  /** Where places of the work are seen, and the camera; null before the first picture. */
  readonly sight: Seen;
  /** What draws it, with the marks that are pressed over it. */
  readonly picture: (marks: ReactNode) => ReactNode;
  /** What can be measured in it; null where the section is measured instead. */
  readonly measured: MeasureSource | null;
  /** The path that is played and timed, and what is said about its moments. */
  readonly timed: TimedRun;
  readonly words: MomentWords;
  /** The picture is older than the typed values. */
  readonly dimmed: boolean;
  /** The playback has ended, and the picture shows what is left. */
  readonly ended?: boolean;
}

/** What is around the pictures, from top to bottom. */
export interface ViewLayers {
  readonly bar?: BarTools;
  /** Replaces a picture without content. */
  readonly empty?: ReactNode;
  readonly legend: ReactNode;
  /** What follows the moment, over the read-out and under it. */
  readonly strip: ReactNode;
  readonly steps?: ReactNode;
  readonly more: ReactNode;
}

/** The marks of a view, and the chosen one. */
export interface ViewPlaces {
  readonly shown: readonly PicturePlace[];
  readonly chosen: PicturePlace | null;
  readonly choose: (place: PicturePlace | null) => void;
}

const NO_TOOLS: BarTools = {};

/** A picture of the machine: tools, stage, read-out, playback and timeline. */
export function View({
  scene,
  beside = null,
  playback,
  clock,
  layers,
  picking,
  places,
}: {
  readonly scene: Scene;
  /** A second one, which is drawn over the first until its own first picture. */
  readonly beside?: Scene<Sight | null> | null;
  readonly playback: PlaybackStore;
  readonly clock: Clock;
  readonly layers: ViewLayers;
  readonly picking: Omit<PlanePicking, "hover">;
  readonly places: ViewPlaces;
}) {
  const t = useTexts().lathe,
    keysId = useId();
  const { motion } = useSettings(),
    work = useEditor((s) => s.work);
  const [tools, showTools] = useState(false);
  const { name, title, sight, timed, words, dimmed, ended = false } = scene,
    { steps } = timed,
    { viewport, measuring } = picking;
  const isBeside = Boolean(beside?.sight);
  const stage = useStage(viewport, measuring.on ? measuring : picking.pointer, isBeside ? 0.5 : 1);
  /** Closes the tools on a small screen to show the picture again; while measuring, the keys go to the picture. */
  const toggle = () => {
    measuring.toggle();
    if (measuring.state.getState().on) stage.current?.focus({ preventScroll: true });
    showTools(false);
  };

  useEffect(() => playback.playsOf(work), [work, playback]);
  useEffect(() => playback.dispatch({ do: "load", track: trackOf(steps) }), [steps, playback]);
  useEffect(() => playback.setStill(reducedMotion({ motion })), [motion, playback]);

  /** Enter in the picture chooses the running move and focuses its dialog, if it has one that is shown. */
  const chooseByKey = ({ key, picture }: { readonly key: string; readonly picture: boolean }) => {
    const { position } = playback.get(),
      step = Math.min(position.step, steps.length - 1);
    if (key !== "Enter" || !picture || step < 0) return false;
    picking.choose(position);
    if (picking.onMove?.(step, true)) stage.current?.blur();
    return true;
  };
  const states = { dimmed, measuring: measuring.on, ended, beside: isBeside };
  const shown: readonly Scene<Sight | null>[] = beside ? [scene, beside] : [scene];
  return (
    <CountedIn value={scene.unit}>
      <section
        className={`lathe ${name}-view`}
        data-tools={tools}
        aria-label={title}
        onKeyDown={(event) => {
          const target = event.target as HTMLElement;
          if (event.ctrlKey || event.metaKey || event.altKey) return;
          const typed = {
            key: event.key,
            shift: event.shiftKey,
            element: target.localName,
            picture: target === stage.current,
          };
          if (pressKey(typed, playback, sight, measuring) || chooseByKey(typed)) event.preventDefault();
        }}
      >
        <ViewBar
          sight={sight}
          measuring={{ ...measuring, toggle }}
          tools={layers.bar ?? NO_TOOLS}
          legend={{ shown: tools, show: showTools }}
        />
        <div
          ref={stage}
          className={["lathe-stage", ...Object.entries(states).flatMap(([name, on]) => (on ? [name] : []))].join(" ")}
          tabIndex={0}
          role="group"
          aria-label={title}
          aria-describedby={keysId}
          data-keys="picture"
          {...{ [KEEPS_KEYBOARD]: "" }}
        >
          {shown.map(({ name: key, picture, sight: seeing, measured }) => (
            <Fragment key={key}>
              {picture(
                seeing && (
                  <PlaceButtons seeing={seeing} places={places.shown} chosen={places.chosen} choose={places.choose} />
                ),
              )}
              {measured && <Measurements viewport={viewport} measuring={measuring} source={measured} />}
            </Fragment>
          ))}
          {!scene.measured && <MeasuredInSection />}
          {layers.empty}
          {dimmed && steps.length > 0 && <Outdated />}
          <p id={keysId} className="unseen">
            {t.keys}
          </p>
        </div>
        {tools && layers.legend}
        <DeferredUntilPaint>
          {layers.strip}
          <Readout playback={playback} words={words} />
          {layers.steps}
        </DeferredUntilPaint>
        <PlaybackBar playback={playback}>
          <span className="lathe-fold">
            <GlyphButton glyph="view" name={t.viewTools} expanded={tools} onPress={() => showTools(!tools)} />
          </span>
        </PlaybackBar>
        <DeferredUntilPaint>
          <Timeline run={timed} playback={playback} />
          <LiveSentence playback={playback} clock={clock} sentence={words.sentence} />
        </DeferredUntilPaint>
        {layers.more && (
          <div className="lathe-more">
            <DeferredUntilPaint>{layers.more}</DeferredUntilPaint>
          </div>
        )}
      </section>
    </CountedIn>
  );
}
