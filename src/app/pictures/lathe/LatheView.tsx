import { Suspense, useEffect, useId, useMemo, useState } from "react";
import { createStore } from "zustand";
import type { PartialWork } from "../../../program/job/partial-work.ts";
import { NO_TIMING } from "../../../program/run/run-times.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { toPlace, type Place } from "../../../view/camera.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import { datumAt, datumIndex } from "../../../view/datum.ts";
import { trackOf } from "../../../view/playback.ts";
import { sceneOf } from "../../../view/scene.ts";
import type { Clock } from "../../base/clock.ts";
import { DeferredUntilPaint } from "../../base/typing.ts";
import { CountedIn, useLengths } from "../../calculation/lengths.ts";
import { LoadPart } from "../load/LoadParts.tsx";
import { createPointedPlace } from "../load/pointed-place.ts";
import { MeasuredInSection, Measurements } from "../measure/Measurements.tsx";
import { useMeasuring } from "../measure/measuring.ts";
import { useLatheSource } from "../measure/source.ts";
import { lazyPart } from "../../base/parts.ts";
import { whichSlot } from "../../document/which-slot.ts";
import { KEEPS_KEYBOARD, type WhichRegion } from "../../place/place.ts";
import { reducedMotion } from "../../base/settings/appearance.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useEditor } from "../../document/store.ts";
import { useMedia } from "../../base/use-media.ts";
import { ChosenPath, HoveredMove } from "./Chosen.tsx";
import { GlyphButton } from "./GlyphButton.tsx";
import { pressKey } from "./keys.ts";
import { knownText } from "./known-text.ts";
import { ClampingNote } from "./ClampingNote.tsx";
import { Legend } from "./Legend.tsx";
import { Marks } from "./Marks.tsx";
import { MoveTable } from "./MoveTable.tsx";
import { Picture } from "./Picture.tsx";
import { PlaceButtons, PlaceLines } from "./PlaceButtons.tsx";
import { sectionProjection } from "./place-projection.ts";
import { findingBounds, usePlaces, type PicturePlace } from "./places.ts";
import { PlaybackBar } from "./PlaybackBar.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { Readout, SpokenStatus, statusText } from "./Readout.tsx";
import { placeText } from "./running.ts";
import { StepList } from "./StepList.tsx";
import { useTaskMarks } from "./task-marks.ts";
import { Timeline } from "./Timeline.tsx";
import { combineViews, useFindingFocus } from "./use-finding-focus.ts";
import { knownParts, partsOf } from "./scene-parts.ts";
import { stretchesOf, useShownPath } from "./use-paths.ts";
import { usePicking } from "./use-picking.ts";
import { usePlayback } from "./use-playback.ts";
import { useMaterial, type LatheResult } from "./use-material.ts";
import { useSolid } from "./use-solid.ts";
import { useStage } from "./use-stage.ts";
import { chooseMove } from "../selection.ts";
import { contourAt } from "../../document/region.ts";
import { OffscreenTool } from "./OffscreenTool.tsx";
import { LegendSwitch, ViewBar } from "./ViewBar.tsx";
import { createViewport } from "./viewport.ts";
import "./lathe.css";
import { Outdated } from "./Outdated.tsx";

/** Loaded for a program with approaches. */
const TurnPoints = lazyPart(async () => ({ default: (await import("../plane/TurnPoints.tsx")).TurnPoints }));
/** Loaded for a dialog: its typed positions. */
const KnownMarks = lazyPart(async () => ({ default: (await import("./KnownMarks.tsx")).KnownMarks }));
const AskedMarks = lazyPart(async () => ({ default: (await import("./KnownMarks.tsx")).AskedMarks }));
/** Loaded on demand: paths of other settings, the 3D view. */
const GhostPaths = lazyPart(async () => ({ default: (await import("./GhostPaths.tsx")).GhostPaths }));
const SolidView = lazyPart(async () => ({ default: (await import("../solid/SolidView.tsx")).SolidView }));
const WhichCycle = lazyPart(async () => ({ default: await whichSlot.fetch() }));

const NOWHERE: readonly PicturePlace[] = [];
const NO_RINGS: readonly Ring[] = [];

const EMPTY_RUN: Run = {
  program: { name: "", unit: "mm", blocks: 0 },
  blank: [],
  clamping: null,
  cuboid: null,
  stated: [],
  operations: [],
  steps: [],
  stepBlocks: [],
  plane: [],
  approaches: [],
  datums: [],
  spindles: [],
  unproved: [],
  issues: [],
  seconds: 0,
  timing: NO_TIMING,
};

/** A move was clicked. `byKey`: chosen by keyboard, so its dialog gets the focus. */
export type MovePointed = (step: number, byKey?: boolean) => void;

/** The lathe: picture, playback, timeline, findings. Keeps showing the last result, dimmed if `dimmed`. */
export function LatheView({
  result,
  known = null,
  dimmed,
  playback,
  clock,
  onMove,
}: {
  readonly result: LatheResult | null;
  /** Values typed so far: drawn while the result has no contour, then only the position of the open prompt. */
  readonly known?: PartialWork | null;
  /** The picture is older than the typed values. */
  readonly dimmed: boolean;
  readonly playback: PlaybackStore;
  readonly clock: Clock;
  /** Called with the index of a clicked move, after the tool went there. */
  readonly onMove?: MovePointed;
}) {
  const texts = useTexts(),
    t = texts.lathe,
    keysId = useId();
  const { section, xDown, motion } = useSettings();
  const work = useEditor((s) => s.work);
  const [kept, keep] = useState(result);
  if (result && result !== kept) keep(result);
  const shown = result ?? (dimmed ? kept : null),
    run = shown?.run ?? EMPTY_RUN;
  const lengths = useLengths(run);
  const { proved, moving } = useMaterial(shown, playback),
    simulation = proved?.simulation ?? null;
  const [viewport] = useState(() => createViewport(!xDown));
  const [tools, showTools] = useState(false);
  const [asking, ask] = useState<WhichRegion | null>(null);

  const typed = run.operations.every((o) => o.plan.contour.length === 0) ? known : null;
  const waiting = run.steps.length === 0 ? typed : null;
  const passes = stretchesOf(run);
  const found = usePlaces("ZX"),
    contacts = useMemo(() => findingBounds(found), [found]);
  const scene = useMemo(
    () =>
      sceneOf({
        ...partsOf(run),
        path: passes.whole,
        ways: passes.ways,
        contacts,
        ...(typed && knownParts(typed, run)),
      }),
    [run, typed, passes, contacts],
  );
  const held = useMemo(() => run.steps.some((step) => step.tool.holder), [run]);
  const starts = useMemo(() => (waiting?.start ? [waiting.start] : run.operations.map((o) => o.start)), [run, waiting]);
  const measuring = useMeasuring();
  const [taken] = useState(() => createStore<readonly LabelBox[]>(() => []));
  const kepts = useMemo(() => [measuring.labels, taken], [measuring, taken]),
    around = { viewport, run, playback, waiting, taken };
  const source = useLatheSource({ run, stockAt: shown?.simulation && moving ? moving.stockAt : null, playback });
  const path = useShownPath(run, passes.stretches, playback);
  const { hover, over, tap } = usePicking({ run, viewport, shown: path.has, onMove });
  const [pointed] = useState(createPointedPlace);
  const point = (at: Place | null) => {
    over(at);
    pointed.set(at && toPlace(viewport.get(), at));
  };
  const look = measuring.on ? measuring : { tap, hover: point, drag: null };
  const solid = useSolid({ run, shown: proved, moving, waiting, chuck: scene.chuck, measures: measuring.on });
  // With enough room, section and 3D view are next to each other.
  const beside = useMedia("vast") && solid.drawn !== null,
    alone = beside ? null : solid.drawn;
  const stage = useStage(viewport, look, beside ? 0.5 : 1);
  const looking = alone ? { ...viewport, ...alone } : viewport;
  /** Closes the tools on a small screen to show the picture again; while measuring, the keys go to the picture. */
  const toggle = () => {
    measuring.toggle();
    if (measuring.state.getState().on) stage.current?.focus({ preventScroll: true });
    showTools(false);
  };

  useEffect(() => playback.playsOf(work), [work, playback]);
  useEffect(() => playback.dispatch({ do: "load", track: trackOf(run.steps) }), [run, playback]);
  useEffect(() => playback.setStill(reducedMotion({ motion })), [motion, playback]);
  useEffect(() => viewport.setBounds(scene.bounds), [scene, viewport]);
  useEffect(() => viewport.setXUp(!xDown), [xDown, viewport]);

  /** Enter in the picture chooses the running move and focuses its dialog. */
  const chooseByKey = ({ key, picture }: { readonly key: string; readonly picture: boolean }) => {
    const { position } = playback.get(),
      step = Math.min(position.step, run.steps.length - 1);
    if (key !== "Enter" || !picture || step < 0) return false;
    chooseMove(run, position);
    stage.current?.blur();
    onMove?.(step, true);
    return true;
  };

  const ended = usePlayback(
    playback,
    (s) => s.get().track.ends.length > 0 && s.get().position.step >= s.get().track.ends.length,
  );
  const resting = usePlayback(playback, (s) => (s.get().playing ? -1 : s.get().position.step));
  const marked = usePlayback(playback, (s) => datumIndex(run.datums, s.get().position.step)),
    datum = datumAt(run.datums, marked);
  const state = useMemo(() => {
    const { x, z } = placeText(lengths, datum),
      rests = resting >= 0 ? statusText(texts, lengths, run, playback) : "";
    const now = typed ? `${rests}. ${knownText(t, lengths, typed.outline)}` : rests;
    return run.datums.length > 0 ? `${now} ${t.countsFrom(x, z)}` : now;
  }, [t, texts, lengths, run, playback, resting, datum, typed]);
  const { told } = useTaskMarks();
  const places = told?.places ?? (dimmed || !simulation ? NOWHERE : found);
  const leads = useMemo(() => run.approaches.filter((a) => a.plane === "ZX"), [run]);
  const { chosen, choose } = useFindingFocus(
    places,
    useMemo(() => combineViews([viewport, solid.drawn]), [viewport, solid.drawn]),
    playback,
  );
  const seen = places.filter((each) => ended || told || each.kind === "finding" || each === chosen);
  const residual = told?.left ?? (ended && simulation ? simulation.proof.residual.map(({ ring }) => ring) : NO_RINGS);
  const gouges = told?.missing ?? simulation?.findings.flatMap(({ rings }) => rings) ?? NO_RINGS;
  return (
    <CountedIn value={run.program.unit}>
      <section
        className="lathe"
        data-tools={tools}
        data-body={alone !== null}
        aria-label={t.title}
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
          onWhich={
            proved && contourAt(proved.run, 0) && !dimmed
              ? () => ask(contourAt(proved.run, playback.get().position.step, proved.simulation.final))
              : null
          }
          legend={<LegendSwitch shown={tools} show={showTools} />}
        />
        <div
          ref={stage}
          className={`lathe-stage${dimmed ? " dimmed" : ""}${measuring.on ? " measuring" : ""}${ended ? " ended" : ""}${
            beside ? " beside" : ""
          }`}
          tabIndex={0}
          role="group"
          aria-label={t.title}
          aria-describedby={keysId}
          data-keys="picture"
          {...{ [KEEPS_KEYBOARD]: "" }}
        >
          {!alone && (
            <>
              <Picture
                of={run}
                viewport={viewport}
                scene={scene}
                moving={moving}
                waiting={waiting}
                gouges={gouges}
                residual={residual}
                section={section}
                name={t.pictures[section](state)}
                path={path.stretches}
                ghosts={
                  <DeferredUntilPaint>
                    <Suspense>
                      <GhostPaths scene={scene} clock={clock} />
                    </Suspense>
                  </DeferredUntilPaint>
                }
                chosen={[
                  <LoadPart.Lines key="load" run={run} shown={path.has} />,
                  <ChosenPath key="chosen" run={run} />,
                ]}
                hovered={<HoveredMove run={run} hover={hover} />}
              >
                {scene.chuck?.unstated && <ClampingNote viewport={viewport} plane={scene.chuck.unstated} />}
                <Marks viewport={viewport} starts={starts} datum={datum} />
                <LoadPart.Mark run={run} seeing={sectionProjection(viewport)} />
                {known && (
                  <Suspense>
                    {typed ? <KnownMarks {...around} known={typed} /> : <AskedMarks {...around} known={known} />}
                  </Suspense>
                )}
                {run.steps.length > 0 && (
                  <OffscreenTool
                    viewport={viewport}
                    playback={playback}
                    run={run}
                    places={seen}
                    datum={datum}
                    kept={kepts}
                  />
                )}
                {leads.length > 0 && (
                  <Suspense>
                    <TurnPoints viewport={viewport} approaches={leads} places={seen} />
                  </Suspense>
                )}
                <PlaceLines seeing={sectionProjection(viewport)} places={seen} />
              </Picture>
              <PlaceButtons seeing={sectionProjection(viewport)} places={seen} chosen={chosen} choose={choose} />
              <Measurements viewport={viewport} measuring={measuring} source={source} />
            </>
          )}
          {solid.work && (
            <Suspense>
              <SolidView
                work={solid.work}
                run={run}
                lines={path.has}
                state={state}
                clock={clock}
                places={seen}
                chosen={chosen}
                choose={choose}
                onDrawn={solid.setDrawn}
              />
            </Suspense>
          )}
          {alone && <MeasuredInSection />}
          {run.steps.length === 0 && run.blank.length === 0 && (
            <p className={waiting ? "lathe-outdated small" : "lathe-empty soft"}>{t.pictureEmpty}</p>
          )}
          {dimmed && run.steps.length > 0 && <Outdated />}
          <p id={keysId} className="unseen">
            {t.keys}
          </p>
        </div>
        {tools && (
          <Legend
            shapes={scene.shapes}
            holder={held}
            clamping={scene.chuck && (scene.chuck.unstated ? "unstated" : "stated")}
          />
        )}
        <DeferredUntilPaint>
          <LoadPart.Strip run={run} viewport={viewport} playback={playback} pointed={pointed} shown={path.has} />
          <Readout run={run} playback={playback} chipAt={moving?.chipAt ?? null} />
          <StepList run={run} playback={playback} />
        </DeferredUntilPaint>
        <PlaybackBar playback={playback}>
          <span className="lathe-fold">
            <GlyphButton glyph="view" name={t.viewTools} expanded={tools} onPress={() => showTools(!tools)} />
          </span>
        </PlaybackBar>
        <DeferredUntilPaint>
          <Timeline run={run} playback={playback} />
          <SpokenStatus run={run} playback={playback} clock={clock} />
        </DeferredUntilPaint>
        {asking && (
          <Suspense>
            <WhichCycle region={asking} done={() => ask(null)} />
          </Suspense>
        )}
        {shown && (
          <div className="lathe-more">
            <DeferredUntilPaint>
              <MoveTable run={run} playback={playback} />
              <LoadPart.Table run={run} playback={playback} />
            </DeferredUntilPaint>
          </div>
        )}
      </section>
    </CountedIn>
  );
}
