import { useMemo } from "react";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { CurrentMeasurement } from "../../view/measure/reading.ts";
import type { DimensionRequest } from "../../view/dimensions/placed-dimensions.ts";
import { measurablePlane } from "../../app/pictures/plane/plane-source.ts";
import { measuredIn } from "../../app/document/edits.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { measurementWords } from "../../app/pictures/measure/measure-words.ts";
import { readIn } from "../../app/pictures/measure/readings.ts";
import { measurableRun } from "../../app/pictures/measure/source.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useEditor } from "../../app/document/store.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

const NOTHING: readonly CurrentMeasurement[] = [];

/** The measurements of the open work that the sheet shows. */
export function useSheetMeasured(outcome: Outcome | null): readonly CurrentMeasurement[] {
  const list = useEditor(measuredIn),
    isShown = useSettings((s) => s.sheetMeasured);
  return useMemo(
    () =>
      outcome && isShown ? [measurableRun, measurablePlane].flatMap((of) => readIn(list, of(outcome.run))) : NOTHING,
    [outcome, list, isShown],
  );
}

/** Those to draw: of the finished part. Intermediate stock and milled planes are not on the drawing. */
export function useDrawnMeasured(
  measured: readonly CurrentMeasurement[],
  run: Run | undefined,
): readonly DimensionRequest[] {
  const t = useTexts("measure"),
    lengths = useLengths(run);
  return useMemo(
    () =>
      measured.flatMap((each) => {
        const {
          measurement: { id, plane, moment },
          figure,
          isStale,
        } = each;
        const isDrawn = !isStale && plane === "ZX" && moment?.block === undefined;
        return isDrawn
          ? [{ key: id, measured: figure, text: measurementWords(t, lengths, each).text, needed: false }]
          : [];
      }),
    [measured, t, lengths],
  );
}

/** The measurements, in words; stale ones are only counted. */
export function SheetMeasured({
  measured,
  run,
  t,
}: {
  readonly measured: readonly CurrentMeasurement[];
  readonly run: Run | undefined;
  readonly t: SheetTexts;
}) {
  const own = useTexts("measure"),
    lengths = useLengths(run);
  if (measured.length === 0) return null;
  const said = measured.filter(({ isStale }) => !isStale),
    old = measured.length - said.length;
  return (
    <section className="sheet-measured">
      <h2>{t.measured}</h2>
      <ul>
        {said.map((each) => (
          <li key={each.measurement.id}>{measurementWords(own, lengths, each).name}</li>
        ))}
      </ul>
      {old > 0 && <p className="sheet-small">{t.measuredOld(old)}</p>}
    </section>
  );
}
