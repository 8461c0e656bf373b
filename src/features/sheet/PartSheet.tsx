import { producedParts } from "../../sim/produced-parts.ts";
import { useId, useMemo } from "react";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { CurrentMeasurement } from "../../view/measure/reading.ts";
import { partDrawing } from "../../view/drawing/part-drawing.ts";
import { forSetter } from "../../view/drawing/setter.ts";
import { FIGURES } from "../../view/drawing/paper.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { useDrawnMeasured } from "./SheetMeasured.tsx";
import type { SheetWords } from "./sheet-words.ts";

/** Room for the drawing next to the facts, mm on paper. */
const ROOM = { width: 124, height: 96 } as const;

/** The set-up to scale, as a drawing for black and white. */
export function PartSheet({
  outcome,
  measured,
  name,
  t,
  words,
}: {
  readonly outcome: Outcome | null;
  readonly measured: readonly CurrentMeasurement[];
  readonly name: string;
  readonly t: SheetTexts;
  readonly words: SheetWords;
}) {
  const drawn = useDrawnMeasured(measured, outcome?.run);
  const hatch = useId();
  const drawing = useMemo(() => {
    if (!outcome) return null;
    const { run, simulation } = outcome;
    return partDrawing(
      forSetter(
        {
          blank: run.blank,
          finished: producedParts(simulation),
          contours: run.operations.map(({ plan: { contour, thread } }) => ({
            segments: contour,
            ...(thread && { thread: { lead: thread.lead, starts: thread.starts } }),
          })),
          clamping: run.clamping,
          measured: drawn,
        },
        words,
      ),
      ROOM,
    );
  }, [outcome, words, drawn]);
  if (!drawing) return <p className="sheet-soft">{t.noDrawing}</p>;
  const { scale, width, height, shapes, texts, omitted } = drawing;
  return (
    <figure className="sheet-part">
      <svg role="img" aria-label={t.drawingOf(name)} viewBox={`0 0 ${width} ${height}`} style={{ width: `${width}mm` }}>
        <pattern id={hatch} width="1.6" height="1.6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <path d="M0 0V1.6" className="sheet-hatch" />
        </pattern>
        {shapes.map(({ role, d }, i) => (
          <path key={i} className={`sheet-${role}`} d={d} {...(role === "section" && { fill: `url(#${hatch})` })} />
        ))}
        {texts.map(({ text, at: { x, y }, turned }, i) => (
          <text
            key={i}
            x={x}
            y={y}
            fontSize={FIGURES}
            className="sheet-figure"
            {...(turned && { transform: `rotate(-90 ${x} ${y})` })}
          >
            {text}
          </text>
        ))}
      </svg>
      <figcaption>
        <b>{t.scale(scale.paper, scale.part)}</b>
        <span>
          {[
            t.brackets,
            ...(outcome?.run.clamping ? [] : [t.chuckNote]),
            ...(omitted > 0 ? [t.leftOut(omitted)] : []),
          ].join(" · ")}
        </span>
      </figcaption>
    </figure>
  );
}
