import type { ReactNode } from "react";
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
import type { Sight } from "./place-projection.ts";

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

/** The tools of one scene: before the ruler, and after it. */
export interface BarTools {
  readonly first?: ReactNode;
  readonly then?: ReactNode;
  /** Tooltip of the ruler, where it does not simply measure. */
  readonly rulerHint?: string;
}

/** Tools of a view: those of its scene, ruler, legend, zoom and fit. */
export function ViewBar({
  sight,
  measuring,
  tools: { first, then, rulerHint },
  legend,
}: {
  readonly sight: Pick<Sight, "zoom" | "fit">;
  readonly measuring: MeasuringShown;
  readonly tools: BarTools;
  /** Shows what lines and letters mean; small screens have a button for all tools instead. */
  readonly legend: { readonly shown: boolean; readonly show: (on: boolean) => void };
}) {
  const t = useTexts().lathe;
  useActions([
    { id: "do.fit", name: t.fit, run: sight.fit },
    { id: "do.ruler", name: t.ruler, run: measuring.toggle },
  ]);
  return (
    <Toolbar className="lathe-viewbar" aria-label={t.viewTools}>
      {first}
      <GlyphButton
        glyph="ruler"
        name={t.ruler}
        text={t.ruler}
        isEarly
        pressed={measuring.on}
        onPress={measuring.toggle}
        {...(rulerHint !== undefined && { hint: rulerHint })}
      />
      {then}
      <span className="legend-switch">
        <GlyphButton
          glyph="view"
          name={t.legend}
          text={t.legend}
          isEarly
          pressed={legend.shown}
          onPress={() => legend.show(!legend.shown)}
        />
      </span>
      <ZoomKeys viewport={sight} />
    </Toolbar>
  );
}

/** The choices of the lathe: section, visible path, colours, and X up or down. */
export function LatheChoices() {
  const t = useTexts().lathe,
    { section, xDown, paths, colours, solid } = useSettings();
  const turnX = () => changeSettings({ xDown: !xDown });
  useActions([{ id: "do.turnX", name: t.xDown, run: turnX }]);
  return (
    <>
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
      <GlyphButton glyph={xDown ? "xDown" : "xUp"} name={t.xDown} text={t.xDown} pressed={xDown} onPress={turnX} />
    </>
  );
}

/** Finds a cycle for the contour; `onWhich` is null without a contour. */
export function WhichButton({ onWhich }: { readonly onWhich: (() => void) | null }) {
  const {
    lathe: t,
    page: { start },
  } = useTexts();
  useActions(onWhich ? [{ id: "do.which", name: t.which, run: onWhich }] : []);
  return (
    <GlyphButton
      glyph="which"
      name={t.which}
      text={start.which}
      disabled={onWhich === null}
      onPress={() => onWhich?.()}
    />
  );
}

/** Zoom and fit, at the end of the bar. */
export function ZoomKeys({ viewport }: { readonly viewport: Pick<Sight, "zoom" | "fit"> }) {
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
