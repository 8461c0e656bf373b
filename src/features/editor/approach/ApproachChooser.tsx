import { useMemo, useState } from "react";
import type { PlaneSegment } from "../../../kernel/plane/plane.ts";
import { isPolar } from "../../../program/motion/approach-fields.ts";
import type { ApproachStatement } from "../../../program/edits/approach-draft.ts";
import type { ApproachContext } from "../../../program/edits/approach-request.ts";
import { suggestedForms, type SuggestedForm } from "../../../view/approach/forms.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { formOf } from "./change-form.ts";
import { FormCard } from "./FormCard.tsx";
import "../../../app/pictures/help/help.css";
import "../../../app/pictures/plane/approach.css";

/** A sample corner for the forms, if there is no contour next to the block. */
const CORNER: readonly PlaneSegment[] = [
  { kind: "line", from: { x: 0, y: 60 }, to: { x: 0, y: 0 } },
  {
    kind: "line",
    from: { x: 0, y: 0 },
    to: { x: 60, y: 0 },
  },
];
const SAMPLE_RADIUS = 8;

/** All eight forms at the same contour, to choose from; their points in Cartesian or polar coordinates. */
export function ApproachChooser({
  context,
  chosen,
  onChoose,
}: {
  readonly context: ApproachContext;
  /** The present form of the block. */
  readonly chosen: Pick<ApproachStatement, "form" | "departing">;
  readonly onChoose: (form: SuggestedForm, polar: boolean) => void;
}) {
  const t = useTexts().approach;
  const { contour, toolRadius } = context;
  const [polar, choosePolar] = useState(isPolar(chosen.form));
  const groups = useMemo(
    () =>
      [false, true].map((departing) => {
        const end = departing ? contour.at(-1) : contour[0];
        const shown = end ? contour : CORNER;
        const outside = end && chosen.departing === departing && !departing ? context.before : null;
        return {
          departing,
          shown,
          forms: suggestedForms(
            {
              contour: shown,
              side: context.side,
              toolRadius: toolRadius > 0 ? toolRadius : end ? 0 : SAMPLE_RADIUS,
              outside,
            },
            departing,
          ),
        };
      }),
    [contour, toolRadius, context.side, context.before, chosen.departing],
  );
  return (
    <section className="form-choice" aria-label={t.choose}>
      <p className="small soft">{t.chooseAbout}</p>
      <div className="form-coordinates" role="group" aria-label={t.coordinates.title}>
        {[false, true].map((each) => (
          <button
            key={String(each)}
            type="button"
            className="button"
            aria-pressed={polar === each}
            disabled={each && context.pole === null && !polar}
            onClick={() => choosePolar(each)}
          >
            {each ? t.coordinates.polar : t.coordinates.cartesian}
          </button>
        ))}
      </div>
      {context.pole === null && <p className="small soft">{t.coordinates.noPole}</p>}
      {groups.map(({ departing, shown, forms }) => (
        <div key={String(departing)} className="form-group">
          <h3>{departing ? t.departure : t.approach}</h3>
          <ul className="form-cards">
            {forms.map((form) => (
              <FormCard
                key={form.shape}
                suggested={form}
                form={formOf(form, polar)}
                contour={shown}
                plane={context.plane}
                onTake={() => onChoose(form, polar)}
                chosen={chosen.departing === departing && chosen.form === formOf(form, polar)}
              />
            ))}
          </ul>
        </div>
      ))}
    </section>
  );
}
