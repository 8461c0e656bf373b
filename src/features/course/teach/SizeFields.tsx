import { formatNumber } from "../../../i18n/number.ts";
import type { SizeDraft } from "../../../course/made/task-form.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { NumberInput } from "../../../app/fields/number/NumberInput.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { FormPart } from "./WordFields.tsx";

/** The sizes of the part, each chosen with its deviations. */
export function SizeFields({ made, change }: FormPart) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const number = (value: number) => formatNumber(language, value);
  const put = (at: number, some: Partial<SizeDraft>) =>
    change({ sizes: made.sizes.map((size, i) => (i === at ? { ...size, ...some } : size)) });
  return (
    <fieldset>
      <legend>{t.sizes}</legend>
      {made.sizes.length === 0 && <p className="soft">{t.noSizes}</p>}
      <ul className="teach-list">
        {made.sizes.map(({ kind, nominal, at, on, upper, lower }, i) => {
          const name = t.size[kind](number(nominal), number(at));
          return (
            <li key={`${kind} ${nominal} ${at}`} className="teach-row">
              <label className="teach-check">
                <input type="checkbox" checked={on} onChange={() => put(i, { on: !on })} />
                {name}
              </label>
              {on && (
                <span className="teach-pair">
                  <NumberInput
                    kind="typed"
                    aria-label={t.upper(name)}
                    text={upper}
                    onText={(text) => put(i, { upper: text })}
                  />
                  <NumberInput
                    kind="typed"
                    aria-label={t.lower(name)}
                    text={lower}
                    onText={(text) => put(i, { lower: text })}
                  />
                </span>
              )}
            </li>
          );
        })}
      </ul>
    </fieldset>
  );
}
