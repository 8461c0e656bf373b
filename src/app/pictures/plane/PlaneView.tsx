import { useCallback, useId, useMemo } from "react";
import { choiceOfMilled } from "../../../program/run/plane-index.ts";
import type { ApproachRun, PlaneStep } from "../../../program/tools/plane-types.ts";
import { planeMotionData } from "../../../view/approach/motion-data.ts";
import { PLANE_ROLES } from "../../../view/approach/plane-scene.ts";
import { areasAt, type MilledStock } from "../../../sim/plane/milled.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { motionAt } from "../../../view/approach/plane-pick.ts";
import { joined } from "../../../view/bounds.ts";
import { ringData } from "../../../view/path.ts";
import type { Clock } from "../../base/clock.ts";
import { View } from "../View.tsx";
import type { LatheResult } from "../lathe/use-material.ts";
import { FlatPicture } from "../lathe/FlatPicture.tsx";
import { Legend, LegendSign } from "../lathe/Legend.tsx";
import { PlaceLines } from "../lathe/PlaceButtons.tsx";
import { usePlaces, type PicturePlace } from "../lathe/places.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useFindingFocus } from "../lathe/use-finding-focus.ts";
import { useFlatScene } from "../lathe/use-flat-scene.ts";
import { usePlayback, useRestingText } from "../lathe/use-playback.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { DepthPicture } from "./DepthPicture.tsx";
import { FreePoints } from "./FreePoints.tsx";
import { useMilledStock } from "./milled.ts";
import { MilledLegend } from "./MilledLegend.tsx";
import { MilledNotes } from "./MilledNotes.tsx";
import { MilledSheet } from "./MilledSheet.tsx";
import { MillSheet } from "./MillSheet.tsx";
import { planeOfRun } from "../../calculation/plane-run.ts";
import { ChosenMotions, PlaneLines } from "./PlaneLines.tsx";
import { measurablePlane } from "./plane-source.ts";
import { PointDot } from "./PointDot.tsx";
import { PlanePoints } from "./PlanePoints.tsx";
import { PointTable } from "./PointTable.tsx";
import { useMilledWords } from "./milled-words.ts";
import { approachSpeech } from "./speech.ts";
import type { MovePointed, Pickable } from "../lathe/use-picking.ts";
import { chooseMove, useChosenApproaches } from "../selection.ts";
import "../help/help.css";
import "./approach.css";

const NO_TIP = { x: 0, y: 0 };
const NOWHERE: readonly PicturePlace[] = [];
const DOTS = ["contour", "centre"] as const;

/** The areas of milled stock at a moment. */
const areasOf = (stock: MilledStock) => (position: PlayPosition) => areasAt(stock.at(position)).flat();

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
  const { run } = result,
    { plane: steps } = run,
    lengths = useLengths(run);
  const { milled, rapids } = useMilledStock(result);
  const through = useMemo(() => ringData(rapids.flatMap(({ rings }) => rings)), [rapids]);
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
  const pickable = useMemo(
    (): Pickable => ({
      find: (place, reach) => motionAt(steps, approaches, place, reach),
      choose({ step, fraction }) {
        const position = { step: Math.min(step, steps.length - 1), fraction };
        chooseMove(choiceOfMilled(run, position.step), position);
      },
    }),
    [run, steps, approaches],
  );
  const grown = typeof milled === "string" ? null : milled;
  const measurable = useMemo(() => measurablePlane(run), [run]),
    stock = useMemo(() => grown && { at: areasOf(grown.stock), reached: grown.stock.reached }, [grown]);
  const bounds = useMemo(() => joined(scene.bounds, grown?.blank ?? null) ?? scene.bounds, [scene, grown]);
  const flat = useFlatScene({ xUp: true, bounds, pickable, onMove, measurable, moves: steps, stock, playback }),
    { viewport, hover } = flat.picking;
  const words = useMilledWords(steps, approaches, lengths, playback),
    rests = useRestingText(playback, words.sentence);
  const found = usePlaces("XY");
  const places = dimmed ? NOWHERE : found;
  const focus = useFindingFocus(places, flat.sight, playback);
  const lines = {
    contour: texts.contour.title,
    rapid: t.rapid,
    feed: own.feedMove,
    lead: `${own.approach} / ${own.departure}`,
  };
  const there = PLANE_ROLES.filter((role) => role !== "contour" && scene.shapes.some((s) => s.role === role));
  return (
    <View
      scene={{
        name: "plane",
        title: own.view,
        unit: run.program.unit,
        sight: flat.sight,
        measured: flat.measured,
        timed,
        words,
        dimmed,
        picture: (pressed) => (
          <>
            <FlatPicture
              viewport={viewport}
              plane="XY"
              name={own.viewPicture(rests)}
              className="plane-picture"
              material={grown && <MilledSheet viewport={viewport} steps={steps} playback={playback} milled={grown} />}
              drawing={
                <>
                  {through !== "" && <path className="shape-gouge plane-rapid-through" d={through} />}
                  <PlaneLines of={run} />
                  <ChosenMotions run={run} />
                </>
              }
              tool={<MillSheet viewport={viewport} steps={steps} playback={playback} />}
              played={{ moves: steps, playback, hover, dataOf: planeMotionData, each: "reading" }}
            >
              <PlanePoints {...{ viewport, approaches, isNamed, speech, places, id }} />
              <FreePoints viewport={viewport} places={places} speech={speech} />
              <PlaceLines seeing={flat.sight} places={places} />
            </FlatPicture>
            <MilledLegend milled={milled} />
            {pressed}
          </>
        ),
      }}
      playback={playback}
      clock={clock}
      picking={flat.picking}
      places={{ shown: places, ...focus }}
      layers={{
        legend: (
          <Legend lines={there.map((role) => [`plane-${role}`, lines[role]])}>
            {approaches.length > 0 &&
              DOTS.map((dot) => (
                <LegendSign key={dot} text={own.dots[dot]}>
                  <PointDot x={13} y={4} onContour={dot === "contour"} />
                </LegendSign>
              ))}
          </Legend>
        ),
        strip: <DepthPicture steps={steps} playback={playback} />,
        more: (
          <>
            {grown && <MilledNotes run={run} rapids={rapids} />}
            <PointTable approaches={approaches} speech={speech} />
          </>
        ),
      }}
    />
  );
}
