import { useCallback, useEffect, useId, useMemo, useState } from "react";
import { Toolbar } from "react-aria-components/Toolbar";
import type { ApproachRun, PlaneStep } from "../../../program/tools/plane-types.ts";
import { PLANE_ROLES } from "../../../view/approach/plane-scene.ts";
import { joined } from "../../../view/bounds.ts";
import { trackOf } from "../../../view/playback.ts";
import type { Clock } from "../../base/clock.ts";
import { DeferredUntilPaint } from "../../base/typing.ts";
import type { MovePointed } from "../lathe/LatheView.tsx";
import type { LatheResult } from "../lathe/use-material.ts";
import { GlyphButton } from "../lathe/GlyphButton.tsx";
import { pressKey } from "../lathe/keys.ts";
import { PlaceButtons, PlaceLines } from "../lathe/PlaceButtons.tsx";
import { sectionProjection } from "../lathe/place-projection.ts";
import { usePlaces } from "../lathe/places.ts";
import { PlaybackBar } from "../lathe/PlaybackBar.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { Timeline } from "../lathe/Timeline.tsx";
import { useFindingFocus } from "../lathe/use-finding-focus.ts";
import { useStage } from "../lathe/use-stage.ts";
import { usePlayback } from "../lathe/use-playback.ts";
import { createViewport } from "../lathe/viewport.ts";
import { LegendSwitch, ZoomKeys } from "../lathe/ViewBar.tsx";
import { Measurements } from "../measure/Measurements.tsx";
import { useMeasuring } from "../measure/measuring.ts";
import { reducedMotion } from "../../base/settings/appearance.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { DepthPicture } from "./DepthPicture.tsx";
import { FreePoints } from "./FreePoints.tsx";
import { useMilledStock } from "./milled.ts";
import { MilledLegend } from "./MilledLegend.tsx";
import { MilledNotes } from "./MilledNotes.tsx";
import { PlanePicture } from "./PlanePicture.tsx";
import { planeOfRun } from "../../calculation/plane-run.ts";
import { cutPlace } from "./plane-places.ts";
import { ChosenMotions, HoveredMotion } from "./PlaneMarks.tsx";
import { usePlaneSource } from "./plane-source.ts";
import { PointDot } from "./PointDot.tsx";
import { PlanePoints } from "./PlanePoints.tsx";
import { PointTable } from "./PointTable.tsx";
import { momentSentence, PlaneReadout, SpokenMoment } from "./PlaneReadout.tsx";
import { approachSpeech } from "./speech.ts";
import { usePlanePicking } from "./use-plane-picking.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
import { chooseMilled, useChosenApproaches } from "../selection.ts";
import "../help/help.css";
import "../lathe/lathe.css";
import "./approach.css";
import { Outdated } from "../lathe/Outdated.tsx";
import { pageLength } from "../../base/unit.ts";

const NO_TIP = { x: 0, y: 0 };
const DOTS = ["contour", "centre"] as const;

/** Chooses the approaches whose points have names: those of the chosen blocks, else the running or next one. */
function useNamedApproach(approaches: readonly ApproachRun[], steps: readonly PlaneStep[], playback: PlaybackStore) {
  const chosen = useChosenApproaches(approaches),
    next = usePlayback(playback, (s) => {
      const running = steps[s.shown().step]?.index ?? 0;
      return (approaches.find(({ index }) => index >= running) ?? approaches.at(-1))?.index ?? null;
    });
  return useCallback((a: ApproachRun) => (chosen.length > 0 ? chosen.includes(a) : a.index === next), [chosen, next]);
}

/**
 * The working plane of a milling program: contours, the path of the tool centre with its named points, the height along
 * the path, playback.
 */
export function PlaneView({
  result,
  dimmed,
  playback,
  clock,
  onMove,
}: {
  readonly result: LatheResult;
  /** The picture is older than the typed values. */
  readonly dimmed: boolean;
  readonly playback: PlaybackStore;
  readonly clock: Clock;
  /** Called with the index of a clicked motion, after the tool went there. */
  readonly onMove?: MovePointed | undefined;
}) {
  const texts = useTexts(),
    t = texts.lathe,
    own = texts.approach,
    id = useId();
  const { motion } = useSettings();
  const [viewport] = useState(() => createViewport(true));
  const [tools, showTools] = useState(false);
  const { run } = result,
    { plane: steps } = run,
    lengths = useLengths(run);
  const { milled, rapids } = useMilledStock(result);
  const { approaches, scene } = planeOfRun(run);
  const timed = useMemo(
    () => ({
      operations: run.operations,
      steps: steps.map((s) => ({
        move: { kind: s.feed === undefined ? "rapid" : "feed" },
        operation: null,
        seconds: s.seconds,
      })),
    }),
    [run, steps],
  );
  const speech = useMemo(() => approachSpeech(lengths, "XY", NO_TIP), [lengths]);
  const isNamed = useNamedApproach(approaches, steps, playback);
  const { hover, over, tap } = usePlanePicking({ run, leads: approaches, viewport, onMove });
  const measuring = useMeasuring();
  const source = usePlaneSource(run, typeof milled === "string" ? null : milled.stock, playback);
  const stage = useStage(viewport, measuring.on ? measuring : { tap, hover: over, drag: null });
  const toggle = () => {
    measuring.toggle();
    if (measuring.state.getState().on) stage.current?.focus({ preventScroll: true });
    showTools(false);
  };

  useEffect(() => playback.dispatch({ do: "load", track: trackOf(steps) }), [steps, playback]);
  useEffect(() => playback.setStill(reducedMotion({ motion })), [motion, playback]);
  const blank = typeof milled === "string" ? null : milled.blank;
  useEffect(() => viewport.setBounds(joined(scene.bounds, blank) ?? scene.bounds), [scene, blank, viewport]);

  const resting = usePlayback(playback, (s) => (s.get().playing ? -1 : s.get().position.step));
  /** Enter in the picture chooses the running motion and focuses its dialog. */
  const chooseByKey = ({ key, picture }: { readonly key: string; readonly picture: boolean }) => {
    const { position } = playback.get(),
      step = Math.min(position.step, steps.length - 1);
    if (key !== "Enter" || !picture || step < 0) return false;
    chooseMilled(run, { ...position, step });
    stage.current?.blur();
    onMove?.(step, true);
    return true;
  };

  const name = useMemo(
    () => own.viewPicture(resting >= 0 ? momentSentence(texts, lengths, steps, approaches, playback.shown()) : ""),
    [own, texts, lengths, steps, approaches, playback, resting],
  );
  const found = usePlaces("XY");
  const places = useMemo(() => (dimmed ? [] : found.map(cutPlace)), [dimmed, found]);
  const { chosen, choose } = useFindingFocus(places, viewport, playback);
  const lines = {
    contour: texts.contour.title,
    rapid: t.rapid,
    feed: own.feedMove,
    lead: `${own.approach} / ${own.departure}`,
  };
  const there = PLANE_ROLES.filter((role) => role !== "contour" && scene.shapes.some((s) => s.role === role));
  return (
    <section
      className="lathe plane-view"
      data-tools={tools}
      aria-label={own.view}
      onKeyDown={(event) => {
        const target = event.target as HTMLElement;
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const typed = {
          key: event.key,
          shift: event.shiftKey,
          element: target.localName,
          picture: target === stage.current,
        };
        if (pressKey(typed, playback, viewport, measuring) || chooseByKey(typed)) event.preventDefault();
      }}
    >
      <Toolbar className="lathe-viewbar" aria-label={t.viewTools}>
        <GlyphButton glyph="ruler" name={t.ruler} text={t.ruler} pressed={measuring.on} onPress={toggle} />
        <LegendSwitch shown={tools} show={showTools} />
        <ZoomKeys viewport={viewport} />
      </Toolbar>
      <div
        ref={stage}
        className={`lathe-stage${dimmed ? " dimmed" : ""}${measuring.on ? " measuring" : ""}`}
        tabIndex={0}
        role="group"
        aria-label={own.view}
        aria-describedby={`${id}keys`}
        {...{ [KEEPS_KEYBOARD]: "" }}
      >
        <PlanePicture
          viewport={viewport}
          run={run}
          playback={playback}
          milled={milled}
          rapids={rapids}
          chosen={<ChosenMotions run={run} />}
          hovered={<HoveredMotion run={run} hover={hover} />}
          name={name}
        >
          <PlanePoints {...{ viewport, approaches, isNamed, speech, places, id }} />
          <FreePoints viewport={viewport} places={places} speech={speech} />
          <PlaceLines seeing={sectionProjection(viewport)} places={places} />
        </PlanePicture>
        <MilledLegend milled={milled} />
        <PlaceButtons seeing={sectionProjection(viewport)} places={places} chosen={chosen} choose={choose} />
        <Measurements viewport={viewport} measuring={measuring} source={source} />
        {dimmed && <Outdated />}
        <p id={`${id}keys`} className="unseen">
          {t.keys}
        </p>
      </div>
      {tools && (
        <div className="lathe-told">
          <ul className="lathe-legend small" aria-label={t.legend}>
            {there.map((role) => (
              <li key={role}>
                <svg width={pageLength(26)} height={pageLength(8)} viewBox="0 0 26 8" aria-hidden="true">
                  <path className={`plane-${role}`} d="M1 4H25" />
                </svg>
                {lines[role]}
              </li>
            ))}
            {approaches.length > 0 &&
              DOTS.map((dot) => (
                <li key={dot}>
                  <svg width={pageLength(26)} height={pageLength(8)} viewBox="0 0 26 8" aria-hidden="true">
                    <PointDot x={13} y={4} onContour={dot === "contour"} />
                  </svg>
                  {own.dots[dot]}
                </li>
              ))}
          </ul>
        </div>
      )}
      <DeferredUntilPaint>
        <DepthPicture steps={steps} playback={playback} />
        <PlaneReadout steps={steps} approaches={approaches} playback={playback} />
      </DeferredUntilPaint>
      <PlaybackBar playback={playback}>
        <span className="lathe-fold">
          <GlyphButton glyph="view" name={t.viewTools} expanded={tools} onPress={() => showTools(!tools)} />
        </span>
      </PlaybackBar>
      <DeferredUntilPaint>
        <Timeline run={timed} playback={playback} />
        <SpokenMoment steps={steps} approaches={approaches} playback={playback} clock={clock} />
        <div className="lathe-more">
          {typeof milled !== "string" && <MilledNotes run={run} rapids={rapids} />}
          <PointTable approaches={approaches} speech={speech} />
        </div>
      </DeferredUntilPaint>
    </section>
  );
}
