import { Suspense } from "react";
import { boxAround } from "../../kernel/area/box.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { proposedClamping } from "../../program/clamping/draft.ts";
import type { BlankDraft } from "../../program/job/job.ts";
import { SETUP_FIELDS } from "../../program/job/setup-fields.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { PlannedPartResult } from "../../planning/part/planned-part.ts";
import { MaterialSelect } from "../../app/fields/said/MaterialField.tsx";
import { ClampingFields } from "../../app/fields/setup/ClampingFields.tsx";
import { NumberField } from "../../app/fields/setup/NumberField.tsx";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import type { StoredPart } from "../../app/records/part-store.ts";
import type { PlanWords } from "../../app/fields/plan/plan-words.ts";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly planned: PlannedPartResult;
  readonly onPart: (part: FinishedPart, place: string | null) => void;
}

const EMPTY: BlankDraft = { outside: "", bore: "", length: "", allowance: "" };
const FIELDS = ["outside", "bore", "length", "allowance"] as const;
/** Assumed size of an unknown blank, mm. */
const SOME_BLANK = { left: -80, right: 0, high: 30 };
const text = (n: number) => String(Number(n.toFixed(3)));

/** Blank, material and clamping of the part. */
export function StockTab({ words: { t, work }, stored: { part }, planned, onPart }: Props) {
  const clamping = useTextsOrNull("clamping");
  const box = planned.blank.length > 0 ? boxAround(planned.blank) : null;
  const outline = part.blank && "outline" in part.blank ? part.blank.outline : null;
  const draft = part.blank && !("outline" in part.blank) ? part.blank : EMPTY;
  const proposed: Readonly<Record<keyof BlankDraft, string | undefined>> = {
    outside: box ? text(toDiameter(radius(box.high))) : undefined,
    bore: box ? text(toDiameter(radius(box.low))) : undefined,
    length: box ? text(box.right - box.left) : undefined,
    allowance: box ? text(box.right) : undefined,
  };
  const put = (change: Partial<BlankDraft>, place: string) => {
    const next = { ...draft, ...change };
    onPart({ ...part, blank: FIELDS.every((each) => next[each].trim() === "") ? null : next }, place);
  };
  const flag = (name: "partsOff" | "unmachinedBehind", label: string) => (
    <label className="choice">
      <input
        type="checkbox"
        checked={part[name]}
        onChange={({ currentTarget: { checked } }) => onPart({ ...part, [name]: checked }, null)}
      />
      <span>{label}</span>
    </label>
  );
  return (
    <div className="plan-fields">
      <Suspense>
        <MaterialSelect id={part.material} choose={(material) => onPart({ ...part, material }, null)} />
      </Suspense>
      <fieldset className="setup-group">
        <legend>{t.stock.blank}</legend>
        {outline ? (
          <>
            <p className="small soft">{t.stock.outline(outline.length)}</p>
            <button type="button" className="button" onClick={() => onPart({ ...part, blank: null }, null)}>
              {t.stock.cylinder}
            </button>
          </>
        ) : (
          FIELDS.map((each) => (
            <NumberField
              key={each}
              field={{ ...SETUP_FIELDS[each], id: `plan.blank.${each}`, optional: true }}
              name={work.setup.blank[each]}
              unit={each === "outside" || each === "bore" ? work.setup.units.diameter : work.setup.units.mm}
              text={draft[each]}
              proposal={proposed[each]}
              onText={(typed) => put({ [each]: typed }, `blank ${each}`)}
            />
          ))
        )}
        {flag("partsOff", t.stock.partsOff)}
        {flag("unmachinedBehind", t.stock.behind)}
      </fieldset>
      <fieldset className="setup-group">
        <legend>{clamping?.title}</legend>
        <ClampingFields
          of="plan."
          draft={part.clamping}
          set={(next, place) => onPart({ ...part, clamping: next }, place)}
          propose={() => proposedClamping(box ?? SOME_BLANK)}
        />
      </fieldset>
    </div>
  );
}
