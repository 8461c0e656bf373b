import { useId } from "react";
import type { Answer } from "../../../course/judge/judgement.ts";
import { calledTools } from "../../../course/judge/rules.ts";
import { TOOL_OFFERS } from "../../../course/made/task-form.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { FormPart } from "./WordFields.tsx";

/** The learner's tools: those of the answer, a selection with others, or all. */
export function ToolFields({ made, change, answer }: FormPart & { readonly answer: Answer }) {
  const t = useTexts("course-teach");
  const name = useId();
  const { offer, tools } = made;
  const called = [...calledTools(answer).keys()].join(", ");
  return (
    <fieldset>
      <legend>{t.offer}</legend>
      <div className="teach-choices" role="radiogroup" aria-label={t.offer}>
        {TOOL_OFFERS.map((each) => (
          <label key={each} className="teach-check">
            <input type="radio" name={name} checked={offer === each} onChange={() => change({ offer: each })} />
            {each === "called" ? t.offers.called(called) : t.offers[each]}
          </label>
        ))}
      </div>
      {offer === "listed" && (
        <div role="group" aria-label={t.offers.listed} className="teach-values teach-tools">
          {shippedTools.map(({ T, NAME }) => (
            <label key={T} className="teach-check">
              <input
                type="checkbox"
                checked={tools.includes(T)}
                onChange={() =>
                  change({
                    tools: tools.includes(T) ? tools.filter((each) => each !== T) : [...tools, T],
                  })
                }
              />
              {t.toolOf(String(T), NAME)}
            </label>
          ))}
        </div>
      )}
    </fieldset>
  );
}
