import { Suspense, useCallback, useEffect, useMemo, useState } from "react";
import { operationsPlayed, stepsPlayed, type StepRange } from "../../course/playback-range.ts";
import type { Run } from "../../program/state/run-types.ts";
import { boundsOf, common, grownBounds, joined, mirrored } from "../../view/bounds.ts";
import type { Bounds } from "../../view/camera.ts";
import { datumAt, datumIndex } from "../../view/datum.ts";
import { sceneOf } from "../../view/scene.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { useLongerThan } from "../../app/calculation/use-longer-than.ts";
import { Marks } from "../../app/pictures/lathe/Marks.tsx";
import { PlaceButtons, PlaceLines } from "../../app/pictures/lathe/PlaceButtons.tsx";
import { sectionProjection } from "../../app/pictures/lathe/place-projection.ts";
import { Picture } from "../../app/pictures/lathe/Picture.tsx";
import type { PlaybackStore } from "../../app/calculation/playback-store.ts";
import { statusText } from "../../app/pictures/lathe/turned-words.ts";
import { useMaterial } from "../../app/pictures/lathe/use-material.ts";
import { stretchesOf } from "../../app/pictures/lathe/use-paths.ts";
import { usePlayback, useRestingText } from "../../app/pictures/lathe/use-playback.ts";
import { createViewport } from "../../app/pictures/lathe/viewport.ts";
import { useStage } from "../../app/pictures/lathe/use-stage.ts";
import { ZoomKeys } from "../../app/pictures/lathe/ViewBar.tsx";
import { lookByKey } from "../../app/pictures/lathe/keys.ts";
import { LoadLines } from "../../app/pictures/load/LoadLines.tsx";
import { LoadMark } from "../../app/pictures/load/LoadMark.tsx";
import type { LoadQuantity } from "../../app/pictures/load/use-load.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { reducedMotion } from "../../app/base/settings/appearance.ts";
import { CountedIn, useLengths } from "../../app/calculation/lengths.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { LessonBar } from "./LessonBar.tsx";
import { LessonFacts } from "./LessonFacts.tsx";
import { useLessonPlaces } from "./use-lesson-places.ts";
import { usePress, usePressedPlace } from "./use-pressed-place.ts";
import type { LessonPageOf } from "./lesson-pages.ts";
import { useLessonLoad } from "./use-lesson-load.ts";
import { usePlaybackRange } from "./use-playback-range.ts";
import "../../app/pictures/lathe/lathe.css";

/** Loaded for a program with approaches. */
const TurnPoints = lazyPart(async () => ({
  default: (await import("../../app/pictures/plane/TurnPoints.tsx")).TurnPoints,
}));

/** Shorter waits show no text, ms. */
const SOON = 300;

const LOOK = { tap: () => undefined, hover: () => undefined };
const EVERY = () => true;
const NOTHING: readonly Ring[] = [];

/** The scene of a run: its blank and contours, its path, and the chuck. */
const sceneOfRun = (run: Run, path: Parameters<typeof sceneOf>[0]["path"]) =>
  sceneOf({
    blank: run.blank,
    clamping: run.clamping,
    contours: run.operations.map((o) => o.plan.contour),
    steps: run.steps,
    ...(path && { path }),
  });

/** Margin around the cut, as a share of its longer side: shows the insert and the ends of the jaws. */
const AIR = 0.2;

/** The section of the lathe that a page requests. */
const framed = ({ x, z }: NonNullable<LessonPageOf["frame"]>): Bounds => ({
  left: z[0],
  right: z[1],
  low: toRadius(diameter(x[0])),
  high: toRadius(diameter(x[1])),
});

/** Default section of a page: the blank and all feed moves, without the whole chuck. */
function frameOf({ blank, steps }: Run, { first, last }: StepRange, whole: Bounds): Bounds {
  const fed = steps.slice(first, last + 1).filter(({ move }) => move.kind !== "rapid");
  const seen = joined(boundsOf(blank.flat()), boundsOf(fed.flatMap(({ from, move }) => [from, move.to])));
  if (!seen) return whole;
  const both = mirrored(seen);
  return common(whole, grownBounds(both, AIR * Math.max(both.right - both.left, both.high - both.low)));
}

/** A question for a place on the part: what is asked for is not marked. */
interface AskedPlace {
  readonly press: (place: Pt) => void;
  readonly pressed: Pt | null;
}

/** The lathe of a page: playback of its program, with the marks and colours of the page. */
export function LessonPicture({
  outcome,
  page,
  playback,
  waits,
  failed,
  slid,
  asked,
}: {
  readonly outcome: Outcome;
  readonly page: LessonPageOf;
  readonly playback: PlaybackStore;
  /** The result of the previous program: the requested one is pending. */
  readonly waits: boolean;
  /** The requested program failed. */
  readonly failed: boolean;
  /** A slider of this page was moved: its picture follows. */
  readonly slid: boolean;
  /** The question asks for a place: a press answers it. */
  readonly asked: AskedPlace | null;
}) {
  const t = useTexts("course");
  const texts = useTexts();
  const { section, xDown, motion } = useSettings();
  const [viewport] = useState(() => createViewport(!xDown));
  const { run, simulation } = outcome;
  const lengths = useLengths(run);
  const dimmed = waits && !slid;
  const isLong = useLongerThan(waits, SOON);
  const played = useMemo(() => stepsPlayed(run.steps, page.blocks), [run, page.blocks]);
  const { moving } = useMaterial(outcome, playback);
  const passes = stretchesOf(run);
  const scene = useMemo(() => sceneOfRun(run, passes.whole), [run, passes]);
  const still = reducedMotion({ motion });
  // While the run of the previous page is shown, this page counts as not opened: playback starts with its own run.
  const opened = dimmed ? `${page.key} waits` : page.key;
  const stretch = usePlaybackRange(playback, run, played, {
    page: opened,
    at: still && page.begins === "play" ? "start" : page.begins,
  });
  // A press in the picture does nothing: its marks are buttons.
  const stage = useStage(viewport, LOOK);
  const told: LoadQuantity | null = page.shows === undefined || page.shows === "residue" ? null : page.shows;
  useLessonLoad(outcome, told);
  useEffect(() => playback.setStill(still), [playback, still]);
  const frame = useMemo(
    () => (page.frame ? framed(page.frame) : frameOf(run, played, scene.bounds)),
    [page.frame, run, played, scene],
  );
  useEffect(() => viewport.setBounds(frame), [frame, viewport]);
  useEffect(() => viewport.fit(), [page.key, viewport]);

  const ended = usePlayback(playback, (s) => s.get().position.step > played.last);
  const state = useRestingText(
    playback,
    useCallback(() => statusText(texts, lengths, run, playback), [texts, lengths, run, playback]),
  );
  const datum = datumAt(
    run.datums,
    usePlayback(playback, (s) => datumIndex(run.datums, s.get().position.step)),
  );
  const places = useLessonPlaces(outcome);
  const [look, setLook] = useState({ page: "", id: "" });
  const chosen = places.find(({ id }) => id === look.id && look.page === page.key) ?? null;
  const choose = (place: typeof chosen) => {
    setLook({ page: page.key, id: place?.id ?? "" });
    playback.dispatch({ do: "pause" });
    if (place?.kind === "residual") stretch.seek(stretch.length);
    else if (place) playback.dispatch({ do: "seek", position: place.position });
    if (place) viewport.show(place.bounds);
    else viewport.fit();
  };
  // With a colour map, residual material is marked only on request: the mark would cover the colours.
  const marked = places.filter((each) => each === chosen || each.kind === "finding" || (ended && told === null));
  const pressed = usePressedPlace(asked?.pressed ?? null);
  const seen = asked ? pressed : marked;
  const { begin, end } = usePress(viewport, asked?.press ?? null);
  const starts = useMemo(() => operationsPlayed(run.operations, played).map(({ start }) => start), [run, played]);
  const leads = useMemo(() => run.approaches.filter((a) => a.plane === "ZX"), [run]);
  const drawn = section === "full" ? "full" : "half";
  return (
    <CountedIn value={run.program.unit}>
      <section className="lesson-picture" aria-label={t.picture.name}>
        <div className="lesson-lathe">
          <div
            ref={stage}
            className={`lathe-stage${dimmed ? " dimmed" : ""}${ended ? " ended" : ""}`}
            data-asked={asked ? true : undefined}
            onPointerDown={begin}
            onClick={end}
            tabIndex={0}
            role="group"
            aria-label={t.picture.name}
            data-keys="picture"
            onKeyDown={(event) => {
              const isHere = event.target === event.currentTarget && !event.ctrlKey && !event.metaKey && !event.altKey;
              if (isHere && lookByKey(event.key, event.shiftKey, viewport)) event.preventDefault();
            }}
          >
            <Picture
              viewport={viewport}
              scene={scene}
              moving={moving}
              waiting={null}
              gouges={simulation.findings.flatMap(({ rings }) => rings)}
              residual={ended && !asked ? simulation.proof.residual.map(({ ring }) => ring) : NOTHING}
              section={drawn}
              name={texts.lathe.pictures[drawn](state)}
              path={passes.stretches}
              chosen={
                told && (
                  <Suspense>
                    <LoadLines of={told} run={run} shown={EVERY} />
                  </Suspense>
                )
              }
            >
              <Marks viewport={viewport} starts={starts} datum={datum} />
              {told && (
                <Suspense>
                  <LoadMark of={told} run={run} seeing={sectionProjection(viewport)} />
                </Suspense>
              )}
              {leads.length > 0 && <TurnPoints viewport={viewport} approaches={leads} places={seen} />}
              <PlaceLines seeing={sectionProjection(viewport)} places={seen} />
            </Picture>
            <PlaceButtons seeing={sectionProjection(viewport)} places={seen} chosen={chosen} choose={choose} />
            <div className="lesson-zoom">
              <ZoomKeys viewport={viewport} />
            </div>
            <p className="lesson-checking small" role="status">
              {failed ? t.picture.failed : isLong && texts.lathe.checking}
            </p>
          </div>
          <LessonBar playback={playback} stretch={stretch} run={run} lines={page.program} />
        </div>
        <LessonFacts outcome={outcome} played={played} told={told} old={isLong || failed} spoken={slid && !waits} />
      </section>
    </CountedIn>
  );
}
