import { Suspense } from "react";
import type { PlannedPartResult } from "../../planning/part/planned-part.ts";
import { lazyWithin } from "../../app/base/parts.ts";
import { contourSlot } from "../../app/fields/slots.ts";
import { chooseElement, useChosenRow } from "../../app/place/contour-place.ts";
import type { StoredPart } from "../../app/records/part-store.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import { ProblemList } from "./ProblemList.tsx";
import { MarkFields, ROUGHNESS } from "./MarkFields.tsx";
import { showSide, usePlanPlace } from "./plan-place.ts";
import { SIDES, tableRows, withTableRows } from "./part-rows.ts";
import type { PlanWords } from "../../app/fields/plan/plan-words.ts";
import { ValueField } from "./ValueField.tsx";

const ContourTable = lazyWithin(async () => ({ default: (await contourSlot.fetch()).ContourTable }));

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly planned: PlannedPartResult;
  readonly onPart: (part: FinishedPart, place: string | null) => void;
}

/** The contours of the part as tables, with the marks of the selected element. */
export function PartTab({ words, stored: { part }, planned, onPart }: Props) {
  const { t, language } = words;
  const side = usePlanPlace((p) => p.side);
  const rows = tableRows(part, side);
  const row = useChosenRow(rows);
  return (
    <>
      <div className="view-switch plan-sides" role="group" aria-label={t.sides.name}>
        {SIDES.map((each) => (
          <button
            key={each}
            type="button"
            className="button"
            aria-pressed={each === side}
            onClick={() => {
              chooseElement(null);
              showSide(each);
            }}
          >
            {t.sides[each]} <span className="number soft">{part[each].length}</span>
          </button>
        ))}
      </div>
      {/* What stands below the table comes with it: nothing moves when it is there. */}
      <Suspense>
        <ContourTable
          key={side}
          rows={rows}
          onChange={(next, place) => onPart(withTableRows(part, side, next), place && `${side} ${place}`)}
          language={language}
          isDrawingElsewhere
        />
        <div className="plan-fields">
          {part.outside.length > 0 && <ProblemList words={words} part={part} problems={planned.problems} />}
          <MarkFields words={words} part={part} side={side} row={row} problems={planned.problems} onPart={onPart} />
          <fieldset className="setup-group">
            <legend>{t.general.title}</legend>
            <ValueField
              name={t.general.roughness}
              unit={t.mark.micron}
              range={ROUGHNESS}
              value={part.general.ra}
              onValue={(ra) => {
                const { ra: _, ...others } = part.general;
                onPart({ ...part, general: ra === undefined ? others : { ...others, ra } }, "general ra");
              }}
            />
          </fieldset>
        </div>
      </Suspense>
    </>
  );
}
