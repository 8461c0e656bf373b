import { radius, toDiameter } from "../../kernel/units.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { MillTool } from "../../program/tool-entry.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { wholeAbove } from "./LiveInsert.tsx";

/** Edges of the drawing, px. */
const WIDTH = 176;
const HEIGHT = 148;

/** A mill to scale from the side: as wide as it cuts, with its axis, and a length to compare it to. */
export function MillDrawing({ mill }: { readonly mill: MillTool | null }) {
  const t = useTexts().tools;
  const language = useSettings((s) => s.language);
  if (!mill)
    return (
      <div className="live-insert">
        <p className="soft small">{t.noDrawing}</p>
      </div>
    );
  const across = toDiameter(radius(mill.R + (mill.DR ?? 0)));
  const span = wholeAbove(Math.max(across * 1.4, 1));
  const scale = HEIGHT / span;
  const half = (across * scale) / 2;
  const bar = wholeAbove(span / 6);
  const middle = WIDTH / 2;
  return (
    <figure className="live-insert" aria-label={t.millDrawing}>
      <svg className="insert-drawing" width={WIDTH} height={HEIGHT} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
        <path className="shape-insert" d={`M${middle - half} 8H${middle + half}V${HEIGHT - 12}H${middle - half}Z`} />
        <path className="insert-tip" strokeDasharray="8 3 2 3" d={`M${middle} 0V${HEIGHT}`} />
      </svg>
      <figcaption className="small">
        <span className="scale-bar number">
          <i style={{ width: `${bar * scale}px` }} /> {t.scale(formatNumber(language, bar))}
        </span>
        <span className="soft number">⌀ {t.scale(formatNumber(language, across))}</span>
      </figcaption>
    </figure>
  );
}
