import { decimalSign, formatNumber } from "../../../i18n/number.ts";
import { VALUE_FORMULAS, type ReasonedNumber } from "../../../planning/values/formulas.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Decimals of an input of a formula. */
const DECIMALS = 3;

/** Why a cutting value is what it is: in words, by its formula, and with the inputs by their symbols. */
export function ValueReason({ of: { formula, inputs } }: { readonly of: Pick<ReasonedNumber, "formula" | "inputs"> }) {
  const { reasons } = useTexts("cutting-values");
  const language = useSettings((s) => s.language);
  const symbols = VALUE_FORMULAS[formula].replace(/\b(\d)\.(\d)/g, `$1${decimalSign(language)}$2`);
  const write = (input: number | string) =>
    typeof input === "number" ? formatNumber(language, input, DECIMALS) : input;
  const given = Object.entries(inputs).map(([symbol, input]) => `${symbol} = ${write(input)}`);
  return (
    <span className="value-reason soft small">
      {reasons[formula]}
      <span className="number"> · {[...(symbols.includes("=") ? [symbols] : []), ...given].join("; ")}</span>
    </span>
  );
}
