import { useContext } from "react";
import type { Pt } from "../../kernel/point.ts";
import { toDiameter } from "../../kernel/units.ts";
import { formatPosition, formatFixed, formatNumber } from "../../i18n/number.ts";
import { toScreen } from "../../view/camera.ts";
import { measure, measuredFor } from "../../view/measure.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { MeasuredInto } from "./measured-into.ts";
import type { Measuring } from "./measuring.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** The ruler in the picture: cross, first place, and the legs of the triangle between two places. */
export function RulerLines({ viewport, measuring: { cross, first, second } }: { readonly viewport: Viewport;
  readonly measuring: Measuring })
{
  const camera = useCamera(viewport);
  const place = (p: Pt) => toScreen(camera, p);
  const a = first && place(first), to = second ?? (first ? cross : null), b = to && place(to), c = cross && place(cross);
  return (
    <g className="lathe-ruler" aria-hidden="true">
      {c && !second && <path className="cross" d={`M${c.x - 12} ${c.y}H${c.x + 12}M${c.x} ${c.y - 12}V${c.y + 12}`} />}
      {a && b && <path className="legs" d={`M${a.x} ${a.y}H${b.x}V${b.y}`} />}
      {a && b && <path className="line" d={`M${a.x} ${a.y}L${b.x} ${b.y}`} />}
      {a && <circle cx={a.x} cy={a.y} r="4" />}
      {second && b && <circle cx={b.x} cy={b.y} r="4" />}
    </g>
  );
}

/** What the ruler reads, in words and numbers; changes are read out. */
export function RulerReading({ measuring: { cross, first, second } }: { readonly measuring: Measuring }) {
  const t = useTexts().lathe, language = useSettings((s) => s.language);
  const target = useContext(MeasuredInto);
  const value = target && (first ? measuredFor(target.kind, second ?? first, second && measure(first, second)) : null);
  const to = second ?? cross, m = first && to ? measure(first, to) : null;
  const n = (v: number) => formatPosition(language, v);
  const said = second && m ? t.rulerResult(n(m.dx), n(m.dz), formatFixed(language, m.distance, 3)) : first ? t.rulerSecond : t.rulerHint;
  return (
    <div className="lathe-reading">
      {m
        ? (
          <dl className="number">
            <div>
              <dt>{t.deltaX}</dt>
              <dd>{n(m.dx)}</dd>
            </div>
            <div>
              <dt>{t.deltaZ}</dt>
              <dd>{n(m.dz)}</dd>
            </div>
            <div>
              <dt>{t.distance}</dt>
              <dd>{formatFixed(language, m.distance, 3)}</dd>
            </div>
          </dl>
        )
        : cross && (
          <dl className="number">
            <div>
              <dt>{t.axisX}</dt>
              <dd>{n(toDiameter(cross.r))}</dd>
            </div>
            <div>
              <dt>{t.axisZ}</dt>
              <dd>{n(cross.z)}</dd>
            </div>
          </dl>
        )}
      {target && value !== null && (
        <button type="button" className="button small" onClick={() => target.take(value)}>
          {t.takeInto(`${target.kind === "diameter" ? "⌀" : ""}${formatNumber(language, value, 3)}`, target.q)}
        </button>
      )}
      <p role="status" className={second ? "unseen" : "small soft"}>{said}</p>
    </div>
  );
}
