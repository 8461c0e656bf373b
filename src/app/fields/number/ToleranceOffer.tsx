import { readToleratedSize } from "../../../kernel/fit/typed-tolerance.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import "./tolerance-offer.css";

interface Props {
  readonly typed: string;
  readonly onTake: (middle: number) => void;
}

/** Decimals of a deviation: half micrometres. */
const DECIMALS = 4;
/** A class of ISO 286 is read from a table, deviations from the text. */
const IS_CLASS = /[a-z]\s*\d+\s*$/i;

/** Proposes the middle of a size that is typed with its tolerance, with its formula; nothing for any other text. */
export function ToleranceOffer({ typed, onTake }: Props) {
  const t = useTexts("cutting-values").tolerance;
  const { takeNearest } = useTexts().dialog;
  const language = useSettings((s) => s.language);
  const read = readToleratedSize(typed);
  if (!read) return null;
  const write = (n: number) => formatNumber(language, n, DECIMALS);
  const signed = (n: number) => (n > 0 ? `+${write(n)}` : write(n));
  const { nominal, upper, lower, middle } = read;
  const sum = `${write(nominal)} + (${write(upper)} ${lower < 0 ? "−" : "+"} ${write(Math.abs(lower))}) / 2`;
  return (
    <div className="tolerance-offer">
      <p className="number">{t.middle(typed.trim(), signed(upper), signed(lower), sum, write(middle))}</p>
      {IS_CLASS.test(typed) && <p className="small soft">{t.source}</p>}
      <button type="button" className="button" onClick={() => onTake(middle)}>
        {takeNearest(write(middle))}
      </button>
    </div>
  );
}
