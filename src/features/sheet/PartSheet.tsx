import { producedParts } from "../../sim/produced-parts.ts";
import { useMemo } from "react";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { CurrentMeasurement } from "../../view/measure/reading.ts";
import { partDrawing } from "../../view/drawing/part-drawing.ts";
import { forSetter } from "../../view/drawing/setter.ts";
import { PaperDrawing } from "../../app/pictures/paper/PaperDrawing.tsx";
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
  const { scale, omitted } = drawing;
  return (
    <figure className="sheet-part">
      <PaperDrawing drawing={drawing} name={t.drawingOf(name)} style={{ width: `${drawing.width}mm` }} />
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
