import { useId } from "react";
import { Toolbar } from "react-aria-components/Toolbar";
import { Menu } from "../../app/base/Menu.tsx";
import { ZOOM, ZoomKeys } from "../../app/pictures/lathe/ViewBar.tsx";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import { GRID_STEPS, type GridStep } from "./snap.ts";
import type { DrawingMode } from "./use-drawing.ts";

/** Icons of the drawing tools, 24 units square. */
const modes = {
  move: "M12 3v18M3 12h18M12 3l-3 3M12 3l3 3M12 21l-3-3M12 21l3-3M3 12l3-3M3 12l3 3M21 12l-3-3M21 12l-3 3",
  draw: "M4 20l4-1L19 8l-3-3L5 16zM14 7l3 3",
  round: "M5 20V13a8 8 0 0 1 8-8h7",
  chamfer: "M5 20V12l7-7h8",
} as const;
/** Three dots: what a narrow bar has no room for. */
const MORE = "M4 12h2M11 12h2M18 12h2";
interface Props {
  readonly mode: DrawingMode;
  readonly step: GridStep;
  readonly language: Language;
  readonly onMode: (mode: DrawingMode) => void;
  readonly onStep: (step: GridStep) => void;
  readonly onZoom: (factor: number) => void;
  readonly onFit: () => void;
}

const Shape = ({ d }: { readonly d: string }) => (
  <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
    <path d={d} />
  </svg>
);

/** The drawing tools: pointer mode, grid and zoom. */
export function DrawingTools({ mode, step, language, onMode, onStep, onZoom, onFit }: Props) {
  const t = texts(language).contour;
  const { zoomIn, zoomOut, fit } = texts(language).lathe;
  const id = useId();
  return (
    <Toolbar aria-label={t.drawTools} className="contour-tools contour-draw-tools">
      {(["move", "draw", "round", "chamfer"] as const).map((m) => (
        <button
          key={m}
          type="button"
          className="button icon"
          aria-label={t.modes[m]}
          title={t.modes[m]}
          aria-pressed={mode === m}
          onClick={() => onMode(m)}
        >
          <Shape d={modes[m]} />{" "}
          <span className="contour-mode" aria-hidden="true">
            {t.modeShort[m]}
          </span>
        </button>
      ))}
      <label htmlFor={id} className="small soft contour-grid-label">
        {t.grid}
      </label>
      <select
        id={id}
        className="select number contour-grid"
        value={step}
        onChange={(e) => onStep(GRID_STEPS.find((s) => s === Number(e.currentTarget.value)) ?? 1)}
      >
        {GRID_STEPS.map((s) => (
          <option key={s} value={s}>
            {formatNumber(language, s)}
          </option>
        ))}
      </select>
      <ZoomKeys viewport={{ zoom: onZoom, fit: onFit }} />
      <span className="contour-more">
        <Menu
          name={t.viewAndGrid}
          label={<Shape d={MORE} />}
          className="button icon"
          groups={[
            [
              { name: fit, go: onFit },
              { name: zoomIn, go: () => onZoom(ZOOM) },
              { name: zoomOut, go: () => onZoom(1 / ZOOM) },
            ],
            GRID_STEPS.map((s) => ({
              name: `${t.grid} ${formatNumber(language, s)}${s === step ? " ✓" : ""}`,
              go: () => onStep(s),
            })),
          ]}
        />
      </span>
    </Toolbar>
  );
}
