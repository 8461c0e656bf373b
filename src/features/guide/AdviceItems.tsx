import type { AdviceTexts } from "../../i18n/en/advice.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import { SPINDLE, type Advice } from "../../report/advice/advise.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { keepFocus } from "./keep-focus.ts";
import { applyValue, useCanApply } from "./apply-value.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** One piece of advice in words. */
function adviceText(t: AdviceTexts, language: Language, { code, data, better }: Advice): string {
  const n = (value: number | null, decimals: number) => formatNumber(language, value ?? 0, decimals);
  switch (code) {
    case "depthOverEdge":
      return t.of[code](n(data.depth, 2), n(data.edge, 1), n(data.most, 2));
    case "feedOverNose":
      return t.of[code](n(data.feed, 3), n(data.nose, 2), n(data.most, 2));
    case "rough":
      return t.of[code](n(data.rz, 1), n(data.feed, 3), n(data.nose, 2), n(data.wanted, 1), n(better, 2));
    case "power":
      return t.of[code](n(data.power, 1), n(data.most, 1), n(data.speed, 0), n(better, 2));
    case "speedLimited":
      return t.of[code](n(data.limit, 0), n(data.heldTo, 1), n(data.smallest, 1), n(data.left, 0));
    case "noLimit":
      return t.of[code](n(data.speed, 0));
    case "speedFar":
      return t.of[code](n(data.speed, 0), n(data.usual, 0));
  }
}

/** Pieces of advice, each with a suitable value. */
export function AdviceItems({ cycle, advice }: { readonly cycle: number; readonly advice: readonly Advice[] }) {
  const t = useTexts("advice");
  const language = useSettings((s) => s.language);
  const canTake = useCanApply(cycle);
  return (
    <ul className="advice-items">
      {advice.map((each) => {
        const { at, better } = each;
        return (
          <li key={`${each.code} ${at}`}>
            <p>
              <b className="number">{at === SPINDLE ? t.spindle : at}</b> {adviceText(t, language, each)}
            </p>
            {better !== null && canTake(at) && (
              <button
                type="button"
                className="button"
                onClick={(event) => {
                  keepFocus(event.currentTarget, "main");
                  void applyValue(cycle, at, better);
                }}
              >
                {t.take(`${at === SPINDLE ? "" : `${at} = `}${formatNumber(language, better)}`)}
              </button>
            )}
          </li>
        );
      })}
    </ul>
  );
}
