import { useId, type CSSProperties } from "react";
import { FIGURES, NEXT, nominalWidth, SMALL, STACKED, widthOf, type PrintText } from "../../../view/drawing/paper.ts";
import type { PartDrawing } from "../../../view/drawing/part-drawing.ts";

/** A size with its deviations, as a print stacks them. */
export function Written({ text }: { readonly text: PrintText }) {
  const {
    at: { x, y },
    turned,
  } = text;
  const start = x - widthOf(text) / 2,
    next = start + nominalWidth(text) + NEXT;
  return (
    <g className="workshop-figure" {...(turned && { transform: `rotate(-90 ${x} ${y})` })}>
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

/** The lines of a workshop drawing, without its figures. */
export function PrintShapes({ print }: { readonly print: PartDrawing }) {
  const hatch = useId();
  return (
    <>
      <pattern id={hatch} width="1.8" height="1.8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <path d="M0 0V1.8" className="workshop-hatch" />
      </pattern>
      {print.shapes.map(({ role, d }, i) => (
        <path key={i} className={`workshop-${role}`} d={d} {...(role === "section" && { fill: `url(#${hatch})` })} />
      ))}
    </>
  );
}

/** The picture of a workshop drawing; `list`: id of the element with the sizes as a list. */
export function DrawnPrint({
  print,
  name,
  list,
  style,
}: {
  readonly print: PartDrawing;
  readonly name: string;
  readonly list: string;
  readonly style?: CSSProperties;
}) {
  return (
    <svg
      role="img"
      aria-label={name}
      aria-describedby={list}
      viewBox={`0 0 ${print.width} ${print.height}`}
      style={style}
    >
      <PrintShapes print={print} />
      {print.texts.map((text, i) => (
        <Written key={i} text={text} />
      ))}
    </svg>
  );
}
