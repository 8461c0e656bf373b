import { useEffect, useMemo, useRef, useState } from "react";
import { diameter, toRadius } from "../../kernel/units.ts";
import { texts } from "../settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { RowsReading } from "../../program/contour-rows.ts";
import type { ContourRow } from "../../program/job.ts";
import { zoomed, type Camera } from "../../view/camera.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { px } from "../../view/help/marks.ts";
import { useSize } from "../help/use-size.ts";
import { DrawingTools } from "./DrawingTools.tsx";
import type { Edited } from "./row-edits.ts";
import { gridSpacing, type GridStep } from "./snap.ts";
import { useDrawing, type DrawingMode } from "./use-drawing.ts";

interface Props {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  /** Index of the row that is being edited; null when none is. */
  readonly active: number | null;
  readonly language: Language;
  readonly onPick: (row: number) => void;
  /** Rows during a gesture; the same `place` is one step of undo. */
  readonly onRows: (rows: readonly ContourRow[], place: string) => void;
  readonly onEdited: (edited: Edited) => void;
}

const faultyRows = (reading: RowsReading) =>
  new Set(
    reading.issues.flatMap(
      ({ row, issue }) => (issue.severity === "info" ? [] : issue.code === "contourCrossesItself" ? [row, issue.data.other - 1] : [row])
    ),
  );

/** The contour of the table, to look at and to edit: arcs as arcs, points numbered and to be dragged, faults at their element. */
export function ContourDrawing({ rows, reading, active, language, onPick, onRows, onEdited }: Props) {
  const t = texts(language).contour;
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box, { width: 380, height: 240 });
  const [mode, setMode] = useState<DrawingMode>("move");
  const [step, setStep] = useState<GridStep>(1);
  const [camera, setCamera] = useState<Camera | null>(null);
  const picture = useMemo(() =>
    contourDrawing({
      contour: reading.contour.segments,
      rowOfSegment: reading.rowOfSegment,
      ends: reading.rows.map((r) => r.end),
      faulty: faultyRows(reading),
      active,
      size,
      camera,
      grid: (scale) => ({ z: gridSpacing(step, scale), r: toRadius(diameter(gridSpacing(step, toRadius(diameter(scale))))) }),
    }), [reading, active, size, camera, step]);
  const drawing = useDrawing({ rows, reading, picture, mode, step, onRows, onEdited, onPick, onCamera: setCamera });
  const { takeBack } = drawing;
  useEffect(() => {
    const onKey = (e: KeyboardEvent) => {
      if (e.key === "Escape" && takeBack()) e.stopPropagation();
    };
    document.addEventListener("keydown", onKey, true);
    return () => document.removeEventListener("keydown", onKey, true);
  }, [takeBack]);
  const zoom = (factor: number) => setCamera(zoomed(picture.camera, factor, { x: size.width / 2, y: size.height / 2 }));
  const name = t.drawing(reading.rows.length) + (active === null ? "" : `, ${t.drawingElement(active + 1)}`);
  const show = (n: number) => formatNumber(language, n, 3);
  const { readout } = drawing;

  return (
    <div className="contour-picture">
      <DrawingTools mode={mode} step={step} language={language} onMode={setMode} onStep={setStep} onZoom={zoom}
        onFit={() => setCamera(null)} />
      <div className={`contour-drawing mode-${mode}`} ref={box}>
        <svg role="img" aria-label={name} viewBox={`0 0 ${size.width} ${size.height}`} onPointerDown={drawing.onPointerDown}
          onPointerMove={drawing.onPointerMove} onPointerUp={drawing.onPointerUp} onPointerCancel={drawing.onPointerCancel}
          onDoubleClick={drawing.onDoubleClick}
        >
          <path className="grid" d={picture.grid} />
          <path className="axis" d={picture.axis} />
          {picture.elements.map((e, i) => (
            <g key={i} data-row={e.row} className={[e.row === active ? "active" : "", e.faulty ? "faulty" : ""].join(" ").trim()}>
              <path className="reach" d={e.d} />
              <path className="element" d={e.d} />
            </g>
          ))}
          {picture.points.map((p, i) => (
            <g key={i} className={`point${p.row === active ? " active" : ""}${p.faulty ? " faulty" : ""}`}>
              <circle className="dot" cx={px(p.place.x)} cy={px(p.place.y)}
                r={rows[p.row]?.kind === "RND" || rows[p.row]?.kind === "CHF" ? 2.5 : 4.5} />
              {p.faulty && <circle className="ring" cx={px(p.place.x)} cy={px(p.place.y)} r={9} />}
              {p.label && <text x={px(p.label.x)} y={px(p.label.y)}>{p.faulty ? `${p.row + 1}!` : p.row + 1}</text>}
            </g>
          ))}
        </svg>
        {readout && (
          <p className="contour-readout number">
            {readout.size === null
              ? `X ⌀ ${show(readout.spot.x)}  Z ${show(readout.spot.z)}`
              : `${mode === "round" ? "R" : "CHF"} ${show(readout.size)}`}
          </p>
        )}
      </div>
    </div>
  );
}
