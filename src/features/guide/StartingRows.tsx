import { cycleByNumber, type ParamTextId } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { ValueReason } from "../../app/fields/said/ValueReason.tsx";
import type { StartingValue } from "./starting.ts";
import { applyValue, useCanApply } from "./apply-value.ts";
import "./setup-start.css";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Starting values with their formulas, each with a button that applies it. */
export function StartingRows({ cycle, rows }: { readonly cycle: number; readonly rows: readonly StartingValue[] }) {
  const t = useTexts("advice");
  const { params: names } = useTexts();
  const language = useSettings((s) => s.language);
  const canTake = useCanApply(cycle);
  const params = cycleByNumber(cycle)?.params ?? {};
  return (
    <ul className="starting-rows">
      {rows.map((row) => {
        const { at, value } = row;
        const param = params[at];
        const name = param ? names[param.text as ParamTextId].label : t.spindle,
          unit = at === SPINDLE ? t.units.speed : param?.kind === "feed" ? t.units.feed : "mm",
          take = t.take(formatNumber(language, value));
        return (
          <li key={at}>
            <span>
              {param && <b className="number">{at}</b>} {name}
            </span>
            <span className="number">
              {formatNumber(language, value)} {unit}
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
            <ValueReason of={row} />
          </li>
        );
      })}
    </ul>
  );
}
