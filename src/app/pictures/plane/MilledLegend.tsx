import { formatNumber } from "../../../i18n/number.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { MOST_MILLED, type NoStock } from "../../calculation/cut-milled.ts";
import { toneName } from "./MilledSheet.tsx";
import type { GrowingStock } from "./milled.ts";

/** Legend of the depth tones in a corner of the picture; without stock, the reason. */
export function MilledLegend({ milled }: { readonly milled: GrowingStock | NoStock }) {
  const t = useTexts().approach.milled,
    lengths = useLengths();
  if (milled === "noBlank") return <p className="milled-legend small soft">{t.noBlank}</p>;
  if (milled === "tooLong")
    return <p className="milled-legend small soft">{t.tooLong(formatNumber(lengths.language, MOST_MILLED))}</p>;
  const { depths, heights, limits, hasLower } = milled.stock,
    lowest = heights.at(-1);
  if (depths.length === 0 || lowest === undefined) return null;
  const row = (tone: number, text: string, isMilled: boolean) => (
    <li key={tone}>
      <span
        className={isMilled ? "milled-tone" : "milled-tone not"}
        style={{ backgroundColor: `var(${toneName(tone, limits.length - 1)})` }}
      />
      <span className="number">{text}</span>
    </li>
  );
  return (
    <ul className="milled-legend small" aria-label={t.title}>
      {heights.map((z, i) => {
        const isMilled = depths.includes(z);
        return row(i, t[isMilled ? "depth" : "shoulder"](lengths.signed(z)), isMilled);
      })}
      {hasLower && row(heights.length, t.lower(lengths.signed(lowest)), false)}
    </ul>
  );
}
