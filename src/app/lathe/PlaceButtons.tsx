import { formatNumber } from "../../i18n/number.ts";
import type { Pt } from "../../kernel/point.ts";
import type { Finding, Residual } from "../../sim/simulation.ts";
import { toScreen } from "../../view/camera.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { letterOf } from "./places.ts";
import { placeText } from "./running.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Where a mark stands from its place, pixels: beside it, so that the place stays to be seen. */
const ASIDE = { x: 18, y: -18 };
/** Never more marks than this on the picture; the list has them all. */
const MOST = 40;

/** Findings and residual regions at their places in the picture: a ring with a number, a tag with a letter. */
export function PlaceButtons({ viewport, findings, residual, chosen, choose }: {
  readonly viewport: Viewport;
  readonly findings: readonly Finding[];
  readonly residual: readonly Residual[];
  readonly chosen: string | null;
  readonly choose: (id: string) => void;
}) {
  const camera = useCamera(viewport), { width, height } = viewport.size();
  const t = useTexts().lathe, language = useSettings(s => s.language);
  const mark = (id: string, kind: "finding" | "residual", text: string, place: Pt, name: string) => {
    const at = toScreen(camera, place);
    if (at.x < SCALE_LEFT || at.x > width || at.y < 0 || at.y > height - SCALE_BELOW) return null;
    return (
      <button key={id} type="button" className={`lathe-place badge badge-${kind}`} style={{ left: at.x + ASIDE.x, top: at.y + ASIDE.y }} title={name} aria-label={name}
        aria-pressed={chosen === id} onClick={() => choose(id)}>{text}</button>
    );
  };
  return (
    <>
      {residual.slice(0, MOST).map((r, i) => {
        const { x, z } = placeText(language, r.place);
        return mark(`r${i}`, "residual", letterOf(i), r.place, `${t.residualTitle} ${letterOf(i)}: ${t.residualLine(formatNumber(language, r.area, 2), x, z, t.reasons[r.reason])}`);
      })}
      {findings.slice(0, MOST).map((f, i) => {
        const { x, z } = placeText(language, f.place);
        return mark(`f${i}`, "finding", String(i + 1), f.place, `${i + 1}: ${t.findingLine(t.findingNames[f.kind], x, z, String(f.block))}`);
      })}
    </>
  );
}

/** The ring round each finding and the leader from each place to its mark. */
export function PlaceLines({ viewport, findings, residual }: {
  readonly viewport: Viewport;
  readonly findings: readonly Finding[];
  readonly residual: readonly Residual[];
}) {
  const camera = useCamera(viewport);
  const leader = (place: Pt, from: number) => {
    const { x, y } = toScreen(camera, place);
    return `M${x + from} ${y - from}L${x + ASIDE.x - 6} ${y + ASIDE.y + 6}`;
  };
  return (
    <g aria-hidden="true">
      <path className="lathe-leader-residual" d={residual.slice(0, MOST).map(r => leader(r.place, 0)).join("")} />
      <path className="lathe-leader-finding" d={findings.slice(0, MOST).map(f => leader(f.place, 6)).join("")} />
      {findings.slice(0, MOST).map((f, i) => {
        const at = toScreen(camera, f.place);
        return <circle key={i} className="lathe-ring" cx={at.x} cy={at.y} r="9" />;
      })}
    </g>
  );
}
