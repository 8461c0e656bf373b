import { useId, type CSSProperties } from "react";
import { FIGURES, NEXT, nominalWidth, SMALL, STACKED, widthOf, type PrintText } from "../../../view/drawing/paper.ts";
import type { PartDrawing } from "../../../view/drawing/part-drawing.ts";
import "./paper-drawing.css";

/** A size with its deviations, as a drawing stacks them. */
export function Written({ text }: { readonly text: PrintText }) {
  const {
    at: { x, y },
    turned,
  } = text;
  const start = x - widthOf(text) / 2,
    next = start + nominalWidth(text) + NEXT;
  return (
    <g className="drawn-figure" {...(turned && { transform: `rotate(-90 ${x} ${y})` })}>
      <text x={start} y={y} fontSize={FIGURES}>
        {text.text}
      </text>
      {text.upper !== undefined && (
        <text x={next} y={y - STACKED} fontSize={FIGURES * SMALL}>
          {text.upper}
        </text>
      )}
      {text.lower !== undefined && (
        <text x={next} y={y + STACKED} fontSize={FIGURES * SMALL}>
          {text.lower}
        </text>
      )}
    </g>
  );
}

/** The lines of a drawing, without its figures. */
export function PaperShapes({ shapes }: Pick<PartDrawing, "shapes">) {
  const hatch = useId();
  return (
    <>
      <pattern id={hatch} width="1.8" height="1.8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <path d="M0 0V1.8" className="drawn-hatch" />
      </pattern>
      {shapes.map(({ role, d }, i) => (
        <path key={i} className={`drawn-${role}`} d={d} {...(role === "section" && { fill: `url(#${hatch})` })} />
      ))}
    </>
  );
}

/** The picture of a drawing with its figures; `list`: id of an element with its sizes as a list. */
export function PaperDrawing({
  drawing: { width, height, shapes, texts },
  name,
  list,
  style,
}: {
  readonly drawing: PartDrawing;
  readonly name: string;
  readonly list?: string;
  readonly style?: CSSProperties;
}) {
  return (
    <svg role="img" aria-label={name} aria-describedby={list} viewBox={`0 0 ${width} ${height}`} style={style}>
      <PaperShapes shapes={shapes} />
      {texts.map((text, i) => (
        <Written key={i} text={text} />
      ))}
    </svg>
  );
}
