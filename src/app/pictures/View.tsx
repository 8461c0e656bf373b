import { useEffect, useId, useState } from "react";
import type { Bounds } from "../../view/camera.ts";
import { trackOf } from "../../view/playback.ts";
import { reducedMotion } from "../base/settings/appearance.ts";
import { useSettings } from "../base/settings/settings.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { DeferredUntilPaint } from "../base/typing.ts";
import { CountedIn } from "../calculation/lengths.ts";
import type { PlaybackStore } from "../calculation/playback-store.ts";
import { useEditor } from "../document/store.ts";
import { KEEPS_KEYBOARD } from "../place/place.ts";
import type { Run } from "../../program/state/run-types.ts";
import { GlyphButton } from "./lathe/GlyphButton.tsx";
import { pressKey } from "./lathe/keys.ts";
import { Outdated } from "./lathe/Outdated.tsx";
import { PlaceButtons } from "./lathe/PlaceButtons.tsx";
import { sectionProjection } from "./lathe/place-projection.ts";
import type { PicturePlace } from "./lathe/places.ts";
import { PlaybackBar } from "./lathe/PlaybackBar.tsx";
import { Timeline, type TimedRun } from "./lathe/Timeline.tsx";
import type { Picking } from "./lathe/use-picking.ts";
import { useStage } from "./lathe/use-stage.ts";
import { ViewBar, type BarTools } from "./lathe/ViewBar.tsx";
import type { Viewport } from "./lathe/viewport.ts";
import { MeasuredInSection, Measurements } from "./measure/Measurements.tsx";
import type { MeasuringShown } from "./measure/measuring.ts";
import type { MeasureSource } from "./measure/source.ts";
import type { Zooming } from "./solid/SolidView.tsx";
import "./lathe/lathe.css";

/** What a view shows: a plane of the work, in full or beside the body in space, or the body alone. */
export interface ViewScene {
  readonly title: string;
  readonly className?: string;
  readonly unit: Run["program"]["unit"];
  readonly viewport: Viewport;
  readonly bounds: Bounds;
  readonly xUp: boolean;
  /** The path that is played and timed. */
  readonly timed: TimedRun;
  readonly measured: MeasureSource;
  /** The picture is older than the typed values. */
  readonly dimmed: boolean;
  /** The playback has ended, and the picture shows what is left. */
  readonly ended?: boolean;
  /** The body in space, once drawn; without it the plane is shown alone. */
  readonly space?: { readonly drawn: Zooming; readonly isBeside: boolean } | null;
}

/** The content of a scene, from back to front and from top to bottom. */
export interface ViewLayers {
  readonly bar?: BarTools;
  readonly picture: React.ReactNode;
  /** Over the picture, under its marks. */
  readonly over?: React.ReactNode;
  readonly space?: React.ReactNode;
  /** Replaces a picture without content. */
  readonly empty?: React.ReactNode;
  readonly legend: React.ReactNode;
  /** What follows the moment, between stage and playback. */
  readonly moment: React.ReactNode;
  /** The moment for screen readers. */
  readonly spoken: React.ReactNode;
  readonly more: React.ReactNode;
}

/** What the pointer does in the plane: it chooses moves, or measures. */
export interface ViewPicking extends Omit<Picking, "hover"> {
  readonly measuring: MeasuringShown;
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
  playback,
  layers,
  picking,
  places,
}: {
  readonly scene: ViewScene;
  readonly playback: PlaybackStore;
  readonly layers: ViewLayers;
  readonly picking: ViewPicking;
  readonly places: ViewPlaces;
}) {
  const t = useTexts().lathe,
    keysId = useId();
  const { motion } = useSettings(),
    work = useEditor((s) => s.work);
  const [tools, showTools] = useState(false);
  const { title, viewport, bounds, xUp, timed, dimmed, ended = false, space = null, className = "" } = scene,
    { steps } = timed,
    { measuring } = picking;
  const alone = space && !space.isBeside ? space.drawn : null,
    looking = alone ? { ...viewport, ...alone } : viewport;
  const stage = useStage(viewport, measuring.on ? measuring : picking.pointer, space?.isBeside ? 0.5 : 1);
  /** Closes the tools on a small screen to show the picture again; while measuring, the keys go to the picture. */
  const toggle = () => {
    measuring.toggle();
    if (measuring.state.getState().on) stage.current?.focus({ preventScroll: true });
    showTools(false);
  };

  useEffect(() => playback.playsOf(work), [work, playback]);
  useEffect(() => playback.dispatch({ do: "load", track: trackOf(steps) }), [steps, playback]);
  useEffect(() => playback.setStill(reducedMotion({ motion })), [motion, playback]);
  useEffect(() => viewport.setBounds(bounds), [bounds, viewport]);
  useEffect(() => viewport.setXUp(xUp), [xUp, viewport]);

  /** Enter in the picture chooses the running move and focuses its dialog. */
  const chooseByKey = ({ key, picture }: { readonly key: string; readonly picture: boolean }) => {
    const { position } = playback.get(),
      step = Math.min(position.step, steps.length - 1);
    if (key !== "Enter" || !picture || step < 0) return false;
    picking.choose(position);
    stage.current?.blur();
    picking.onMove?.(step, true);
    return true;
  };
  const states = { dimmed, measuring: measuring.on, ended, beside: space?.isBeside === true };
  return (
    <CountedIn value={scene.unit}>
      <section
        className={`lathe ${className}`.trim()}
        data-tools={tools}
        data-body={alone !== null}
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
          if (pressKey(typed, playback, looking, measuring) || chooseByKey(typed)) event.preventDefault();
        }}
      >
        <ViewBar
          viewport={looking}
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
          {!alone && (
            <>
              {layers.picture}
              {layers.over}
              <PlaceButtons
                seeing={sectionProjection(viewport)}
                places={places.shown}
                chosen={places.chosen}
                choose={places.choose}
              />
              <Measurements viewport={viewport} measuring={measuring} source={scene.measured} />
            </>
          )}
          {layers.space}
          {alone && <MeasuredInSection />}
          {layers.empty}
          {dimmed && steps.length > 0 && <Outdated />}
          <p id={keysId} className="unseen">
            {t.keys}
          </p>
        </div>
        {tools && layers.legend}
        <DeferredUntilPaint>{layers.moment}</DeferredUntilPaint>
        <PlaybackBar playback={playback}>
          <span className="lathe-fold">
            <GlyphButton glyph="view" name={t.viewTools} expanded={tools} onPress={() => showTools(!tools)} />
          </span>
        </PlaybackBar>
        <DeferredUntilPaint>
          <Timeline run={timed} playback={playback} />
          {layers.spoken}
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
