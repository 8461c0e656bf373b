import { useEffect, useEffectEvent, useLayoutEffect, useMemo, useState } from "react";
import { useStore } from "zustand";
import type { MeasuredPlace } from "../../../kernel/plan/measured.ts";
import { part } from "../../../kernel/geometry/point.ts";
import { toScreen, type Camera } from "../../../view/camera.ts";
import { circleAt } from "../../../view/dimensions/strokes.ts";
import { textWidth, type LabelBox } from "../../../view/dimensions/labels.ts";
import { namePlace } from "../../../view/measure/name-place.ts";
import { polyline } from "../../../view/help/marks.ts";
import { placedDimensions } from "../../../view/dimensions/placed-dimensions.ts";
import { onSide, halfOf } from "../../../view/measure/snap.ts";
import { SCALE_BELOW, SCALE_LEFT } from "../lathe/Axes.tsx";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useMedia } from "../../base/use-media.ts";
import { MeasuredLabels, type DraggedLabel } from "./MeasuredLabels.tsx";
import { MeasurePanel } from "./MeasurePanel.tsx";
import { measurementWords } from "./measure-words.ts";
import { measureHand } from "./hand.ts";
import type { Measuring, MeasureState } from "./measuring.ts";
import { useReadings } from "./readings.ts";
import type { MeasureSource } from "./source.ts";
import "./measure.css";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Half size of a mark and of the cross, and letters of its name, pixels. */
const MARK = 5,
  CROSS = 12,
  NAME = 12;

const marks: Readonly<Record<MeasuredPlace["spot"], string>> = {
  corner: `M${-MARK} ${-MARK}H${MARK}V${MARK}H${-MARK}Z`,
  centre: circleAt({ x: 0, y: 0 }, MARK),
  edge: `M${-MARK} ${-MARK}L${MARK} ${MARK}M${-MARK} ${MARK}L${MARK} ${-MARK}`,
  path: `M0 ${-MARK}L${MARK} 0L0 ${MARK}L${-MARK} 0Z`,
  free: "",
};

/** The edge that the cross is snapped to, within half a pixel. */
function heldEdge({ edge, at: p }: MeasuredPlace, camera: Camera, isTurned: boolean): string {
  if (!edge) return "";
  const side = halfOf({ isTurned }, p);
  return polyline(part.flattened(edge.segment, 0.5 / camera.scale).map((each) => toScreen(camera, onSide(each, side))));
}

/** The name of what the cross is snapped to, and its box. */
interface PlacedName {
  readonly text: string;
  readonly box: LabelBox;
}

/** Cross, its snapped edge, and the first place. */
function Cross({
  state: { cross, first },
  camera,
  name,
  isTurned,
}: {
  readonly state: MeasureState;
  readonly camera: Camera;
  readonly name: PlacedName | null;
  readonly isTurned: boolean;
}) {
  const c = cross && toScreen(camera, cross.at),
    a = first && toScreen(camera, first.at);
  return (
    <g className="measure-cross">
      {first && <path className="measure-edge" d={heldEdge(first, camera, isTurned)} />}
      {cross && <path className="measure-edge" d={heldEdge(cross, camera, isTurned)} />}
      {a && c && <path className="measure-way" d={polyline([a, c])} />}
      {a && <circle cx={a.x} cy={a.y} r="4" />}
      {cross && c && (
        <g transform={`translate(${c.x} ${c.y})`}>
          <path className="cross" d={`M${-CROSS} 0H${CROSS}M0 ${-CROSS}V${CROSS}`} />
          <path className="mark" d={marks[cross.spot]} />
        </g>
      )}
      {name && (
        <text x={name.box.x} y={name.box.y + NAME}>
          {name.text}
        </text>
      )}
    </g>
  );
}

/** Margin around texts, pixels. */
const AIR = 6;
/** Room of the buttons over a narrow picture, pixels. */
const BUTTONS = 56;

/** Measurements as dimensions over a picture, and the tools while measuring. */
export function MeasureLayer({
  viewport,
  measuring,
  source,
}: {
  readonly viewport: Viewport;
  readonly measuring: Measuring;
  readonly source: MeasureSource;
}) {
  const t = useTexts("measure"),
    lengths = useLengths(),
    isNarrow = useMedia("narrow");
  const camera = useCamera(viewport),
    size = viewport.size();
  const readings = useReadings(source),
    state = useStore(measuring.state);
  const sourceNow = useEffectEvent(() => source),
    textsNow = useEffectEvent(() => t);
  // Before the tools are visible, because their keys work as soon as they are.
  useLayoutEffect(
    () => measuring.serve(measureHand(measuring, { viewport, source: () => sourceNow(), texts: () => textsNow() })),
    [measuring, viewport],
  );
  const [moved, move] = useState<DraggedLabel | null>(null),
    [panel, keep] = useState<LabelBox | null>(null);
  const isTurned = source.plane === "ZX";
  const words = useMemo(
    () => new Map(readings.map((each) => [each.measurement.id, measurementWords(t, lengths, each)])),
    [readings, t, lengths],
  );
  const standing = useMemo(() => {
    const left = SCALE_LEFT + AIR,
      right = isNarrow ? BUTTONS : AIR;
    const room = { x: left, y: AIR, width: size.width - left - right, height: size.height - SCALE_BELOW - 2 * AIR };
    return placedDimensions(
      { camera, unit: 1, size, room, kept: panel && state.on ? [panel] : [] },
      readings.map(({ measurement: { id, text }, figure }) => {
        const put = moved?.id === id ? moved.to : text,
          { text: said = "", caption = "" } = words.get(id) ?? {};
        return { key: id, measured: figure, text: said, caption, needed: true, ...(put && { put }) };
      }),
    );
  }, [camera, size, isNarrow, panel, state.on, readings, words, moved]);
  const { cross } = state;
  const name = useMemo(() => {
    const text = cross
      ? [t.spots[cross.spot], ...(cross.edge ? [t.owners[cross.edge.of]] : [])]
          .filter((each) => each !== "")
          .join(" · ")
      : "";
    if (!state.on || !cross || text === "") return null;
    const kept = [...standing.map(({ box }) => box), ...(panel ? [panel] : [])];
    return { text, box: namePlace(toScreen(camera, cross.at), textWidth(text, NAME), size, kept) };
  }, [state.on, cross, t, camera, size, standing, panel]);
  useEffect(() => {
    measuring.labels.setState([...standing.map(({ box }) => box), ...(name ? [name.box] : [])], true);
    return () => measuring.labels.setState([], true);
  }, [measuring, standing, name]);
  const old = new Set(readings.flatMap(({ isStale, measurement: { id } }) => (isStale ? [id] : [])));
  return (
    <>
      <svg className="sheet measure-sheet" viewBox={`0 0 ${size.width} ${size.height}`} aria-hidden="true">
        {standing.map(({ key, lines, arrows }) => (
          <g key={key} className={old.has(key) ? "measured old" : "measured"}>
            <path className="line" d={lines} />
            <path className="arrow" d={arrows} />
          </g>
        ))}
        {state.on && <Cross state={state} camera={camera} name={name} isTurned={isTurned} />}
      </svg>
      <MeasuredLabels standing={standing} words={words} old={old} camera={camera} moved={moved} move={move} />
      {state.on && (
        <MeasurePanel
          measuring={measuring}
          source={source}
          state={state}
          readings={readings}
          words={words}
          kept={keep}
        />
      )}
    </>
  );
}
