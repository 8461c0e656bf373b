import { formatNumber } from "../../i18n/number.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import type { StartingValue } from "./starting.ts";
import { applyValue, useCanApply } from "./apply-value.ts";
import "./setup-start.css";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Starting values, each with a button that applies it. */
export function StartingRows({ cycle, rows }: { readonly cycle: number; readonly rows: readonly StartingValue[] }) {
  const t = useTexts("advice");
  const language = useSettings((s) => s.language);
  const canTake = useCanApply(cycle);
  return (
    <ul className="starting-rows">
      {rows.map(({ at, of, value }) => {
        const name = t.values[of],
          take = t.take(formatNumber(language, value));
        return (
          <li key={of}>
            <span>
              {at !== SPINDLE && <b className="number">{at}</b>} {name}
            </span>
            <span className="number">
              {formatNumber(language, value)} {at === SPINDLE ? t.units.speed : t.units.feed}
            </span>
            {canTake(at) && (
              <button
                type="button"
                className="button"
                aria-label={`${name}: ${take}`}
                onClick={() => void applyValue(cycle, at, value)}
              >
                {take}
              </button>
            )}
          </li>
        );
      })}
    </ul>
  );
}
