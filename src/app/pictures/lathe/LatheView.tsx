import { Suspense, useMemo, useState } from "react";
import { createStore } from "zustand";
import type { PartialWork } from "../../../program/job/partial-work.ts";
import { NO_TIMING } from "../../../program/run/run-times.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { toPlace } from "../../../view/camera.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import { datumAt, datumIndex } from "../../../view/datum.ts";
import { sceneOf } from "../../../view/scene.ts";
import type { Clock } from "../../base/clock.ts";
import { DeferredUntilPaint } from "../../base/typing.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { LoadPart } from "../load/LoadParts.tsx";
import { createPointedPlace } from "../load/pointed-place.ts";
import { measurableRun } from "../measure/source.ts";
import { lazyPart, lazyWithin } from "../../base/parts.ts";
import { whichSlot } from "../../document/which-slot.ts";
import type { WhichRegion } from "../../place/place.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useMedia } from "../../base/use-media.ts";
import { View, type Scene } from "../View.tsx";
import { ChosenPath } from "./Chosen.tsx";
import type { PointerActions } from "./gestures.ts";
import { knownText } from "./known-text.ts";
import { ClampingNote } from "./ClampingNote.tsx";
import { TurnedLegend } from "./TurnedLegend.tsx";
import { Marks } from "./Marks.tsx";
import { MoveTable } from "./MoveTable.tsx";
import { Picture } from "./Picture.tsx";
import { PlaceLines } from "./PlaceButtons.tsx";
import type { Sight } from "./place-projection.ts";
import { findingBounds, usePlaces, type PicturePlace } from "./places.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useTurnedWords } from "./turned-words.ts";
import { placeText } from "./running.ts";
import { StepList } from "./StepList.tsx";
import { useTaskMarks } from "./task-marks.ts";
import { combineViews, useFindingFocus } from "./use-finding-focus.ts";
import { knownParts, partsOf } from "./scene-parts.ts";
import { stretchesOf, useShownPath } from "./use-paths.ts";
import { turnedPickable } from "./turned-pickable.ts";
import { useFlatScene } from "./use-flat-scene.ts";
import type { MovePointed } from "./use-picking.ts";
import { usePlayback, useRestingText } from "./use-playback.ts";
import { useMaterial, type LatheResult } from "./use-material.ts";
import { useSolid } from "./use-solid.ts";
import { contourAt } from "../../document/region.ts";
import { OffscreenTool } from "./OffscreenTool.tsx";
import { LatheChoices, WhichButton } from "./ViewBar.tsx";

/** Loaded for a program with approaches. */
const TurnPoints = lazyPart(async () => ({ default: (await import("../plane/TurnPoints.tsx")).TurnPoints }));
/** Loaded for a dialog: its typed positions. */
const KnownMarks = lazyWithin(async () => ({ default: (await import("./KnownMarks.tsx")).KnownMarks }));
const AskedMarks = lazyWithin(async () => ({ default: (await import("./KnownMarks.tsx")).AskedMarks }));
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
    t = texts.lathe;
  const { section, xDown, solid: isSolid } = useSettings();
  const [kept, keep] = useState(result);
  if (result && result !== kept) keep(result);
  const shown = result ?? (dimmed ? kept : null),
    run = shown?.run ?? EMPTY_RUN;
  const lengths = useLengths(run);
  const { proved, moving } = useMaterial(shown, playback),
    simulation = proved?.simulation ?? null;
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
  const stockAt = shown?.simulation ? moving?.stockAt : undefined;
  const measurable = useMemo(() => measurableRun(run), [run]),
    stock = useMemo(() => (stockAt ? { at: stockAt, reached: () => Infinity } : null), [stockAt]);
  const path = useShownPath(run, passes.stretches, playback);
  const pickable = useMemo(() => turnedPickable(run, path.has), [run, path.has]);
  const { bounds } = scene,
    flat = useFlatScene({ xUp: !xDown, bounds, pickable, onMove, measurable, moves: run.steps, stock, playback }),
    { viewport, measuring, hover } = flat.picking;
  const [taken] = useState(() => createStore<readonly LabelBox[]>(() => []));
  const kepts = useMemo(() => [measuring.labels, taken], [measuring, taken]),
    around = { viewport, run, playback, waiting, taken };
  const [pointed] = useState(createPointedPlace);
  const pointer: PointerActions = {
    ...flat.picking.pointer,
    hover: (at) => {
      flat.picking.pointer.hover(at);
      pointed.set(at && toPlace(viewport.get(), at));
    },
  };
  const solid = useSolid({ run, shown: proved, moving, waiting, chuck: scene.chuck, measures: measuring.on });
  // With enough room, section and 3D view are next to each other.
  const isBeside = useMedia("vast");

  const ended = usePlayback(
    playback,
    (s) => s.get().track.ends.length > 0 && s.get().position.step >= s.get().track.ends.length,
  );
  const words = useTurnedWords(run, lengths, playback, moving?.chipAt ?? null),
    rests = useRestingText(playback, words.sentence);
  const marked = usePlayback(playback, (s) => datumIndex(run.datums, s.get().position.step)),
    datum = datumAt(run.datums, marked);
  const state = useMemo(() => {
    const { x, z } = placeText(lengths, datum);
    const now = typed ? `${rests}. ${knownText(t, lengths, typed.outline)}` : rests;
    return run.datums.length > 0 ? `${now} ${t.countsFrom(x, z)}` : now;
  }, [t, lengths, run, rests, datum, typed]);
  const { told } = useTaskMarks();
  const places = told?.places ?? (dimmed || !simulation ? NOWHERE : found);
  const leads = useMemo(() => run.approaches.filter((a) => a.plane === "ZX"), [run]);
  const focus = useFindingFocus(
    places,
    useMemo(() => combineViews([flat.sight, solid.drawn]), [flat.sight, solid.drawn]),
    playback,
  );
  const seen = places.filter((each) => ended || told || each.kind === "finding" || each === focus.chosen);
  const residual = told?.left ?? (ended && simulation ? simulation.proof.residual.map(({ ring }) => ring) : NO_RINGS);
  const gouges = told?.missing ?? simulation?.findings.flatMap(({ rings }) => rings) ?? NO_RINGS;
  const which =
    proved && contourAt(proved.run, 0) && !dimmed
      ? () => ask(contourAt(proved.run, playback.get().position.step, proved.simulation.final))
      : null;
  const turned = { title: t.title, unit: run.program.unit, timed: run, words, dimmed, ended };
  const flatScene: Scene = {
    ...turned,
    name: "section",
    sight: flat.sight,
    measured: flat.measured,
    picture: (pressed) => (
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
              <GhostPaths scene={scene} clock={clock} />
            </DeferredUntilPaint>
          }
          chosen={[<LoadPart.Lines key="load" run={run} shown={path.has} />, <ChosenPath key="chosen" run={run} />]}
          hover={hover}
        >
          {scene.chuck?.unstated && <ClampingNote viewport={viewport} plane={scene.chuck.unstated} />}
          <Marks viewport={viewport} starts={starts} datum={datum} />
          <LoadPart.Mark run={run} seeing={flat.sight} />
          {known && (
            <Suspense>
              {typed ? <KnownMarks {...around} known={typed} /> : <AskedMarks {...around} known={known} />}
            </Suspense>
          )}
          {run.steps.length > 0 && (
            <OffscreenTool viewport={viewport} playback={playback} run={run} places={seen} datum={datum} kept={kepts} />
          )}
          {leads.length > 0 && <TurnPoints viewport={viewport} approaches={leads} places={seen} />}
          <PlaceLines seeing={flat.sight} places={seen} />
        </Picture>
        {pressed}
      </>
    ),
  };
  const space: Scene<Sight | null> | null = solid.work && {
    ...turned,
    name: "space",
    sight: solid.drawn,
    measured: null,
    picture: (pressed) =>
      solid.work && (
        <SolidView
          work={solid.work}
          run={run}
          lines={path.has}
          state={state}
          clock={clock}
          places={seen}
          onDrawn={solid.setDrawn}
        >
          {pressed}
        </SolidView>
      ),
  };
  const alone = space && solid.drawn && !isBeside ? { ...space, sight: solid.drawn } : null;
  return (
    <>
      <View
        scene={alone ?? flatScene}
        beside={alone ? null : space}
        playback={playback}
        clock={clock}
        picking={{ ...flat.picking, pointer }}
        places={{ shown: seen, ...focus }}
        layers={{
          bar: {
            first: <LatheChoices />,
            then: <WhichButton onWhich={which} />,
            ...(isSolid && { rulerHint: t.rulerFlat }),
          },
          empty: run.steps.length === 0 && run.blank.length === 0 && (
            <p className={waiting ? "lathe-outdated small" : "lathe-empty soft"}>{t.pictureEmpty}</p>
          ),
          legend: (
            <TurnedLegend
              shapes={scene.shapes}
              holder={held}
              clamping={scene.chuck && (scene.chuck.unstated ? "unstated" : "stated")}
            />
          ),
          strip: (
            <LoadPart.Strip run={run} viewport={viewport} playback={playback} pointed={pointed} shown={path.has} />
          ),
          steps: <StepList run={run} playback={playback} />,
          more: shown && (
            <>
              <MoveTable run={run} playback={playback} />
              <LoadPart.Table run={run} playback={playback} />
            </>
          ),
        }}
      />
      {asking && <WhichCycle region={asking} done={() => ask(null)} />}
    </>
  );
}
