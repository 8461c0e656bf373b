import { boxOf } from "../../../kernel/area/box.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { radius, rounded, toDiameter } from "../../../kernel/units.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import type { StockSurface } from "../../../program/job/stock-surface.ts";
import { useLengths } from "../../../app/calculation/lengths.ts";

interface Props {
  readonly words: InsertTexts;
  readonly stock: readonly Ring[];
  readonly surfaces: readonly StockSurface[];
  readonly chosen: StockSurface;
  readonly onChoose: (surface: StockSurface) => void;
}

/** Margin around the drawing, as a share of its larger side. */
const MARGIN = 0.06;

function surfaceText(words: InsertTexts, { number }: Lengths, { site, from, to }: StockSurface): string {
  const across = (r: number) => number(rounded(toDiameter(radius(Math.max(0, r)))));
  return site === "face"
    ? words.face(number(rounded(from.z)), across(from.r), across(to.r))
    : words.cylinder(across(from.r), number(rounded(from.z)), number(rounded(to.z)));
}

/** The stock before an operation; its surfaces are chosen in the drawing or in the list. */
export function StockPlace({ words, stock, surfaces, chosen, onChoose }: Props) {
  const lengths = useLengths();
  const { left, right, low, high } = boxOf(stock.flat());
  const bottom = Math.min(0, low);
  const margin = MARGIN * Math.max(right - left, high - bottom, 1);
  const view = `${left - margin} ${-high - margin} ${right - left + 2 * margin} ${high - bottom + 2 * margin}`;
  const index = surfaces.indexOf(chosen);
  return (
    <div className="wide stock-place">
      <svg viewBox={view} role="img" aria-label={words.picture(surfaces.length)} preserveAspectRatio="xMidYMid meet">
        <path
          className="stock-place-area"
          d={stock.map((ring) => ring.map((p, i) => `${i === 0 ? "M" : "L"}${p.z} ${-p.r}`).join("") + "Z").join("")}
        />
        <path className="stock-place-axis" d={`M${left - margin} 0H${right + margin}`} />
        {surfaces.map((surface, i) => {
          const d = `M${surface.from.z} ${-surface.from.r}L${surface.to.z} ${-surface.to.r}`;
          return (
            <g
              key={i}
              className={surface === chosen ? "stock-place-chosen" : undefined}
              onClick={() => onChoose(surface)}
            >
              <path className="stock-place-target" d={d} />
              <path className="stock-place-line" d={d} />
            </g>
          );
        })}
      </svg>
      <label>
        <span>{words.surface}</span>
        <select
          className="select"
          value={index}
          onChange={(event) => {
            const surface = surfaces[Number(event.target.value)];
            if (surface) onChoose(surface);
          }}
        >
          {surfaces.map((surface, i) => (
            <option key={i} value={i}>
              {surfaceText(words, lengths, surface)}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
