import { memo, useEffect, useId, useMemo, useRef, useState, type KeyboardEvent, type ReactNode } from "react";
import type { Ring } from "../../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { toScreen, zoomed, type Camera, type Margin, type Place } from "../../view/camera.ts";
import { WORKPIECE_ZERO } from "../../view/datum.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { px } from "../../view/help/marks.ts";
import { useSize } from "../../app/pictures/help/use-size.ts";
import { CameraAxes } from "../../app/pictures/lathe/Axes.tsx";
import { ZeroMark } from "../../app/pictures/lathe/Marks.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useFingers } from "../../app/base/use-media.ts";
import { DrawingDimensions } from "./DrawingDimensions.tsx";
import { BlankOutline, HoldSigns, SnapLines } from "./DrawingLayers.tsx";
import { useNotedRows } from "./RowNotes.tsx";
import { DrawingTools } from "./DrawingTools.tsx";
import { pressDrawingKey } from "./drawing-keys.ts";
import { holdSigns } from "./hold-signs.ts";
import type { Edited } from "./row-edits.ts";
import { gridSpacing, type GridStep } from "./snap.ts";
import { useDrawing, type DrawingMode } from "./use-drawing.ts";
import { useWheel } from "./use-wheel.ts";

/** Additions of the drawing on the large canvas. */
export interface Canvas {
  readonly blank: readonly Ring[];
  /** Controls in front of the tools. */
  readonly lead: ReactNode;
  /** Hint in the middle while there is no element. */
  readonly empty: ReactNode;
}

interface Props {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  /** Index of the row that is being edited; null when none is. */
  readonly active: number | null;
  readonly language: Language;
  /** Axes, blank and dimensions; without it the drawing is a small one beside its table. */
  readonly canvas?: Canvas;
  readonly onPick: (row: number) => void;
  /** Rows during a gesture; the same `place` is one step of undo. */
  readonly onRows: (rows: readonly ContourRow[], place: string | null) => void;
  readonly onEdited: (edited: Edited) => void;
}

/** Scales along two edges, a row of positions over the lower one, diameters along the right one. */
const MARGINS: Readonly<Record<"mouse" | "fingers", Margin>> = {
  mouse: { left: 66, right: 100, top: 34, bottom: 78 },
  fingers: { left: 60, right: 92, top: 24, bottom: 86 },
};
const NO_RINGS: readonly Ring[] = [];

const faultyRows = (reading: RowsReading) =>
  new Set(
    reading.issues.flatMap(({ row, issue }) =>
      issue.severity === "info" ? [] : issue.code === "contourCrossesItself" ? [row, issue.data.other - 1] : [row],
    ),
  );

/**
 * An element, and the wider line that catches the pointer. Memoized: of a thousand elements only the moved ones render.
 */
const ElementLine = memo(
  ({
    row,
    d,
    active,
    faulty,
  }: {
    readonly row: number;
    readonly d: string;
    readonly active: boolean;
    readonly faulty: boolean;
  }) => (
    <g data-row={row} className={[active ? "active" : "", faulty ? "faulty" : ""].join(" ").trim()}>
      <path className="reach" d={d} />
      <path className="element" d={d} />
    </g>
  ),
);
ElementLine.displayName = "ElementLine";

interface PointProps {
  readonly row: number;
  readonly x: ReturnType<typeof px>;
  readonly y: ReturnType<typeof px>;
  readonly active: boolean;
  readonly faulty: boolean;
  /** The drawing left something open here. */
  readonly noted: boolean;
  /** The middle of a rounding or a chamfer. */
  readonly corner: boolean;
  readonly labelX: ReturnType<typeof px> | null;
  readonly labelY: ReturnType<typeof px> | null;
}

/** The end of an element, with its number if there is room. */
const PointMark = memo(({ row, x, y, active, faulty, noted, corner, labelX, labelY }: PointProps) => (
  <g className={`point${active ? " active" : ""}${faulty ? " faulty" : ""}`}>
    <circle className="dot" cx={x} cy={y} r={corner ? 2.5 : 4.5} />
    {noted && <circle className="ring noted" cx={x} cy={y} r={9} />}
    {faulty && <circle className="ring" cx={x} cy={y} r={9} />}
    {labelX !== null && labelY !== null && (
      <text x={labelX} y={labelY}>
        {faulty ? `${row + 1}!` : row + 1}
      </text>
    )}
  </g>
));
PointMark.displayName = "PointMark";

/** The editable drawing of the contour: arcs as arcs, draggable numbered points, faults at their elements. */
export function ContourDrawing({ rows, reading, active, language, canvas, onPick, onRows, onEdited }: Props) {
  const t = texts(language).contour,
    keysId = useId();
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box, { width: 380, height: 240 });
  const fingers = useFingers(),
    xUp = !useSettings((s) => s.xDown);
  const [mode, setMode] = useState<DrawingMode>(rows.length === 0 ? "draw" : "move");
  const [step, setStep] = useState<GridStep>(1);
  /** Elements are chosen and moved by keys: place and kind of the chosen one are written and spoken. */
  const [keyed, setKeyed] = useState(false);
  const [camera, setCamera] = useState<Camera | null>(null);
  const large = canvas !== undefined,
    blank = canvas?.blank ?? NO_RINGS;
  const picture = useMemo(
    () =>
      contourDrawing({
        contour: reading.contour.segments,
        rowOfSegment: reading.rowOfSegment,
        ends: reading.rows.map((r) => r.end),
        faulty: faultyRows(reading),
        active,
        size,
        camera,
        ...(large && { margin: MARGINS[fingers ? "fingers" : "mouse"], xUp, beside: blank.flat() }),
        grid: (scale) => ({
          z: gridSpacing(step, scale),
          r: toRadius(diameter(gridSpacing(step, toRadius(diameter(scale))))),
        }),
      }),
    [reading, active, size, camera, step, large, fingers, xUp, blank],
  );
  const noted = useNotedRows(rows);
  const signs = useMemo(() => holdSigns(rows, reading, picture, active), [rows, reading, picture, active]);
  const drawing = useDrawing({
    rows,
    reading,
    picture,
    mode,
    step,
    onRows,
    onEdited,
    onPick,
    camera,
    onCamera: setCamera,
  });
  const { takeBack, pointing } = drawing;
  useEffect(() => {
    const onKey = (e: globalThis.KeyboardEvent) => {
      if (e.key === "Escape" && takeBack()) e.stopPropagation();
    };
    document.addEventListener("keydown", onKey, true);
    return () => document.removeEventListener("keydown", onKey, true);
  }, [takeBack]);
  const zoom = (factor: number, at: Place = { x: size.width / 2, y: size.height / 2 }) =>
    setCamera(zoomed(picture.camera, factor, at));
  useWheel(box, zoom);
  const name = t.drawing(reading.rows.length) + (active === null ? "" : `, ${t.drawingElement(active + 1)}`);
  const show = (n: number) => formatNumber(language, n, 3);
  const spokenElement = (row: number): string => {
    const { kind, r } = rows[row] ?? { kind: "L", r: "" },
      end = reading.rows[row]?.end;
    const place = end ? `X ⌀ ${show(end.x)}  Z ${show(end.z)}` : kind === "RND" ? `R ${r}` : r;
    return `${t.kinds[kind]} ${row + 1}  ${place}`.trim();
  };
  const last = mode === "draw" && pointing?.row === null ? reading.rows.findLast((r) => r.end)?.end : null;
  const tools = (
    <DrawingTools
      mode={mode}
      step={step}
      language={language}
      onMode={setMode}
      onStep={setStep}
      onZoom={zoom}
      onFit={() => setCamera(null)}
    />
  );
  const onKeyDown = (e: KeyboardEvent<HTMLDivElement>) => {
    if (e.target !== box.current || e.ctrlKey || e.metaKey) return;
    const done = pressDrawingKey(e, {
      rows,
      reading,
      active,
      camera: picture.camera,
      step,
      xUp,
      onPick,
      onEdited,
      onRows,
      onZoom: zoom,
      onCamera: setCamera,
    });
    if (!done) return;
    e.preventDefault();
    setKeyed(true);
  };
  const spoken = keyed && active !== null ? spokenElement(active) : "";

  return (
    <div className={`contour-picture${large ? " large" : ""}`}>
      {canvas ? (
        <div className="contour-bar">
          {canvas.lead}
          {tools}
        </div>
      ) : (
        tools
      )}
      <div
        className={`contour-drawing mode-${mode}`}
        ref={box}
        {...(large && {
          tabIndex: 0,
          role: "group",
          "aria-label": t.canvas,
          "aria-describedby": keysId,
          "data-keys": "contourDrawing",
          onKeyDown,
          onBlur: () => setKeyed(false),
          onPointerDown: () => setKeyed(false),
        })}
      >
        <svg
          className="contour-sheet"
          role="img"
          aria-label={name}
          viewBox={`0 0 ${size.width} ${size.height}`}
          onPointerDown={drawing.onPointerDown}
          onPointerMove={drawing.onPointerMove}
          onPointerUp={drawing.onPointerUp}
          onPointerCancel={drawing.onPointerCancel}
          onPointerLeave={drawing.onPointerLeave}
          onDoubleClick={drawing.onDoubleClick}
        >
          <path className="grid" d={picture.grid} />
          {large && <BlankOutline blank={blank} camera={picture.camera} />}
          <path className="axis" d={picture.axis} />
          {large && <ZeroMark at={toScreen(picture.camera, WORKPIECE_ZERO)} />}
          {picture.elements.map((e, i) => (
            <ElementLine key={i} row={e.row} d={e.d} active={e.row === active} faulty={e.faulty} />
          ))}
          {large && <HoldSigns signs={signs} active={active} />}
          {picture.points.map((p) => (
            <PointMark
              key={p.row}
              row={p.row}
              x={px(p.place.x)}
              y={px(p.place.y)}
              active={p.row === active}
              faulty={p.faulty}
              noted={noted.has(p.row)}
              corner={rows[p.row]?.kind === "RND" || rows[p.row]?.kind === "CHF"}
              labelX={p.label && px(p.label.x)}
              labelY={p.label && px(p.label.y)}
            />
          ))}
          {pointing && pointing.size === null && (
            <SnapLines
              pointing={pointing}
              camera={picture.camera}
              size={size}
              from={last ? toScreen(picture.camera, { z: axial(last.z), r: toRadius(diameter(last.x)) }) : null}
            />
          )}
          {large && <CameraAxes camera={picture.camera} size={size} part="scales" />}
        </svg>
        {large && (
          <DrawingDimensions
            rows={rows}
            reading={reading}
            picture={picture}
            signs={signs}
            size={size}
            chosen={active}
            language={language}
            onPick={onPick}
            onTyped={(next) => onRows(next, null)}
          />
        )}
        {rows.length === 0 && canvas?.empty}
        {pointing && (
          <p className="contour-readout number">
            {pointing.size === null
              ? `X ⌀ ${show(pointing.aim.spot.x)}  Z ${show(pointing.aim.spot.z)}`
              : `${mode === "round" ? "R" : "CHF"} ${show(pointing.size)}`}
          </p>
        )}
        {large && (
          <p role="status" className={spoken === "" || pointing ? "unseen" : "contour-readout number"}>
            {spoken}
          </p>
        )}
        {large && (
          <p id={keysId} className="unseen">
            {t.canvasKeys}
          </p>
        )}
      </div>
    </div>
  );
}
