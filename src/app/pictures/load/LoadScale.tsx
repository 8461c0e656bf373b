import { classesOf, classTone } from "../../../view/load/scale.ts";
import type { LoadDrawing } from "../../../view/load/lines.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { toneClass } from "./LoadLines.tsx";
import { loadNumber, type LoadQuantity } from "./use-load.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { pageLength } from "../../base/unit.ts";

/** Length and height of a sample of a line, pixels. */
const LONG = 34,
  HIGH = 10;

function Sample({ tone, limited = false }: { readonly tone: number | null; readonly limited?: boolean }) {
  return (
    <svg width={pageLength(LONG)} height={pageLength(HIGH)} aria-hidden="true" className={toneClass(tone)}>
      <line className={limited ? "load-line load-limited" : "load-line"} x2="100%" y1="50%" y2="50%" />
    </svg>
  );
}

/** The classes with their numbers, and the other line styles in use. */
export function LoadScale({
  of,
  drawing: { scale, lines },
}: {
  readonly of: LoadQuantity;
  readonly drawing: LoadDrawing;
}) {
  const t = useTexts("load"),
    lengths = useLengths(),
    unit = lengths.words(t.units[of]);
  const bounds = scale.bounds.map((bound) => loadNumber(lengths, of, bound)),
    last = classesOf(scale) - 1;
  // Each class is at least as wide as its number, which is long in inches.
  const minWidth = `${Math.max(...bounds.map((bound) => bound.length)) + 1}ch`,
    end = `${bounds[last + 1]} ${unit}`;
  const limited = lines.find((line) => line.limited);
  return (
    <ul className="load-scale number" aria-label={t.scale}>
      {Array.from({ length: last + 1 }, (_, i) => (
        <li key={i} style={{ minWidth, ...(i === last && { marginRight: `${end.length + 1}ch` }) }}>
          <Sample tone={classTone(scale, i)} />
          <span className="unseen">{t.between(bounds[i] ?? "", bounds[i + 1] ?? "", unit)}</span>
          <span aria-hidden="true" className="load-bound">
            {bounds[i]}
          </span>
          {i === last && (
            <span aria-hidden="true" className="load-bound load-last">
              {end}
            </span>
          )}
        </li>
      ))}
      {limited && (
        <li className="load-word">
          <Sample tone={limited.tone} limited />
          {t.limited}
        </li>
      )}
      {lines.some(({ tone }) => tone === null) && (
        <li className="load-word">
          <Sample tone={null} />
          {t.notByNose}
        </li>
      )}
    </ul>
  );
}
