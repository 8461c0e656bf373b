import { useId } from "react";
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

/** A drawing with its figures, black on white when printed. */
export function PaperDrawing({ shapes, texts }: Pick<PartDrawing, "shapes" | "texts">) {
  return (
    <>
      <PaperShapes shapes={shapes} />
      {texts.map((text, i) => (
        <Written key={i} text={text} />
      ))}
    </>
  );
}
