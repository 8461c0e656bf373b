import {
  LIST_RULES,
  NUMBER_RULES,
  type ListRule,
  type NumberRule,
  type RuleDraft,
} from "../../../course/made/task-form.ts";
import { NumberInput } from "../../../app/fields/number/NumberInput.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { FormPart } from "./WordFields.tsx";

/** The rules of the shop, each switched on with its number. */
export function RuleFields({ made, change }: FormPart) {
  const t = useTexts("course-teach");
  const put = (rule: NumberRule | ListRule, some: Partial<RuleDraft>) =>
    change({ rules: { ...made.rules, [rule]: { ...made.rules[rule], ...some } } });
  return (
    <fieldset>
      <legend>{t.rules}</legend>
      <p className="small soft">{t.rulesHint}</p>
      <ul className="teach-list">
        {[...NUMBER_RULES, ...LIST_RULES].map((rule) => {
          const { on, text } = made.rules[rule];
          return (
            <li key={rule} className="teach-row">
              <label className="teach-check">
                <input type="checkbox" checked={on} onChange={() => put(rule, { on: !on })} />
                {t.rule[rule]}
              </label>
              <NumberInput
                kind="typed"
                inputMode={rule === "cycles" ? "text" : "decimal"}
                aria-label={t.rule[rule]}
                disabled={!on}
                text={text}
                onText={(next) => put(rule, { text: next })}
              />
            </li>
          );
        })}
        <li className="teach-row">
          <label className="teach-check">
            <input type="checkbox" checked={made.clean} onChange={() => change({ clean: !made.clean })} />
            {t.clean}
          </label>
        </li>
      </ul>
    </fieldset>
  );
}
