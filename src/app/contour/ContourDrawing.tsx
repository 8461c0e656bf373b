import { useMemo, useRef } from "react";
import { texts } from "../settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import type { RowsReading } from "../../program/contour-rows.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { px } from "../../view/help/marks.ts";
import { useSize } from "../help/use-size.ts";

interface Props {
  readonly reading: RowsReading;
  /** Index of the row that is being edited; null when none is. */
  readonly active: number | null;
  readonly language: Language;
  readonly onPick: (row: number) => void;
}

/** The contour of the table: arcs as arcs, points numbered, the edited element strong, faults at their element. */
export function ContourDrawing({ reading, active, language, onPick }: Props) {
  const t = texts(language).contour;
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box, { width: 380, height: 220 });
  const drawing = useMemo(() => contourDrawing({
    contour: reading.contour.segments, rowOfSegment: reading.rowOfSegment,
    ends: reading.rows.map((r) => r.end), faulty: new Set(reading.issues.map((found) => found.row)), active, size,
  }), [reading, active, size]);
  const name = t.drawing(reading.rows.length) + (active === null ? "" : `, ${t.drawingElement(active + 1)}`);
  return (
    <div className="contour-drawing" ref={box}>
      <svg role="img" aria-label={name} viewBox={`0 0 ${size.width} ${size.height}`}>
        <path className="axis" d={drawing.axis} />
        {drawing.elements.map((e, i) => (
          <g key={i} className={[e.row === active ? "active" : "", e.faulty ? "faulty" : ""].join(" ").trim()} onClick={() => onPick(e.row)}>
            <path className="reach" d={e.d} />
            <path className="element" d={e.d} />
          </g>
        ))}
        {drawing.points.map((p, i) => (
          <g key={i} className={`point${p.row === active ? " active" : ""}${p.faulty ? " faulty" : ""}`} onClick={() => onPick(p.row)}>
            <circle className="dot" cx={px(p.place.x)} cy={px(p.place.y)} r={3.5} />
            {p.faulty && <circle className="ring" cx={px(p.place.x)} cy={px(p.place.y)} r={8} />}
            {p.label && <text x={px(p.label.x)} y={px(p.label.y)}>{p.faulty ? `${p.row + 1}!` : p.row + 1}</text>}
          </g>
        ))}
      </svg>
    </div>
  );
}
