import { Toolbar } from "react-aria-components/Toolbar";
import { useActions } from "../../base/actions.ts";
import {
  changeSettings,
  SECTION_VIEWS,
  SHOWN_COLOURS,
  SHOWN_PATHS,
  useSettings,
} from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { Glyph, type GlyphName } from "./Glyph.tsx";
import { GlyphButton } from "./GlyphButton.tsx";
import type { MeasuringShown } from "../measure/measuring.ts";
import type { Viewport } from "./viewport.ts";

/** Zoom per press. */
export const ZOOM = 1.4;

/** A select box: with its text, or with only its glyph where the bar has no room. */
function Choice<Value extends string>({
  name,
  glyph,
  value,
  all,
  words,
  quiet,
  onChoose,
}: {
  readonly name: string;
  readonly glyph?: GlyphName;
  readonly value: Value;
  readonly all: readonly Value[];
  readonly words: Readonly<Record<Value, string>>;
  /** Value that needs no emphasis. */
  readonly quiet?: Value;
  readonly onChoose: (value: Value) => void;
}) {
  return (
    <label className={glyph ? "lathe-choice with-glyph" : "lathe-choice"}>
      <span className="unseen">{name}</span>
      {glyph && <Glyph name={glyph} />}
      <select
        className="select"
        title={name}
        value={value}
        data-chosen={quiet !== undefined && value !== quiet}
        onChange={({ target }) => onChoose(all.find((each) => each === target.value) ?? value)}
      >
        {all.map((each) => (
          <option key={each} value={each}>
            {words[each]}
          </option>
        ))}
      </select>
    </label>
  );
}

/** View settings: section, X up or down, ruler, zoom and fit. */
export function ViewBar({
  viewport,
  measuring,
  onWhich,
  legend,
}: {
  readonly viewport: Viewport;
  readonly measuring: MeasuringShown;
  /** Finds a cycle for the contour; null without a contour. */
  readonly onWhich: (() => void) | null;
  readonly legend: React.ReactNode;
}) {
  const {
      lathe: t,
      page: { start },
    } = useTexts(),
    section = useSettings((s) => s.section),
    down = useSettings((s) => s.xDown);
  const paths = useSettings((s) => s.paths),
    colours = useSettings((s) => s.colours),
    solid = useSettings((s) => s.solid);
  const turnX = () => changeSettings({ xDown: !down });
  useActions([
    { id: "do.fit", name: t.fit, run: viewport.fit },
    { id: "do.turnX", name: t.xDown, run: turnX },
    { id: "do.ruler", name: t.ruler, run: measuring.toggle },
    ...(onWhich ? [{ id: "do.which", name: t.which, run: onWhich } as const] : []),
  ]);
  return (
    <Toolbar className="lathe-viewbar" aria-label={t.viewTools}>
      <div className="lathe-choices">
        <Choice
          name={t.sections.title}
          value={solid ? "solid" : section}
          all={[...SECTION_VIEWS, "solid"]}
          words={t.sections}
          onChoose={(value) =>
            changeSettings({ solid: value === "solid", ...(value !== "solid" && { section: value }) })
          }
        />
        <Choice
          glyph="paths"
          name={t.paths.title}
          value={paths}
          all={SHOWN_PATHS}
          words={t.paths}
          quiet="all"
          onChoose={(value) => changeSettings({ paths: value })}
        />
        <Choice
          glyph="colours"
          name={t.colours.title}
          value={colours}
          all={SHOWN_COLOURS}
          words={t.colours}
          quiet="none"
          onChoose={(value) => changeSettings({ colours: value })}
        />
      </div>
      <GlyphButton glyph={down ? "xDown" : "xUp"} name={t.xDown} text={t.xDown} pressed={down} onPress={turnX} />
      <GlyphButton
        glyph="ruler"
        name={t.ruler}
        text={t.ruler}
        isEarly
        pressed={measuring.on}
        onPress={measuring.toggle}
        {...(solid && { hint: t.rulerFlat })}
      />
      <GlyphButton
        glyph="which"
        name={t.which}
        text={start.which}
        disabled={onWhich === null}
        onPress={() => onWhich?.()}
      />
      {legend}
      <ZoomKeys viewport={viewport} />
    </Toolbar>
  );
}

/** Shows what lines and letters mean; small screens have a button for all tools instead. */
export function LegendSwitch({ shown, show }: { readonly shown: boolean; readonly show: (on: boolean) => void }) {
  const t = useTexts().lathe;
  return (
    <span className="legend-switch">
      <GlyphButton glyph="view" name={t.legend} text={t.legend} isEarly pressed={shown} onPress={() => show(!shown)} />
    </span>
  );
}

/** Zoom and fit, at the end of the bar. */
export function ZoomKeys({ viewport }: { readonly viewport: Pick<Viewport, "zoom" | "fit"> }) {
  const t = useTexts().lathe;
  return (
    <>
      <div className="lathe-gap" />
      <GlyphButton glyph="zoomOut" name={t.zoomOut} onPress={() => viewport.zoom(1 / ZOOM)} />
      <GlyphButton glyph="zoomIn" name={t.zoomIn} onPress={() => viewport.zoom(ZOOM)} />
      <GlyphButton glyph="fit" name={t.fit} onPress={viewport.fit} />
    </>
  );
}
