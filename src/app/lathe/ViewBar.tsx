import { Toolbar } from "react-aria-components/Toolbar";
import { changeSettings, SECTION_VIEWS, SHOWN_COLOURS, SHOWN_PATHS, useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { GlyphButton } from "./GlyphButton.tsx";
import type { Measuring } from "../measure/measuring.ts";
import type { Viewport } from "./viewport.ts";

/** Zoom per press. */
export const ZOOM = 1.4;

/** How the picture is looked at: which section, X up or down, ruler, zoom and fit. */
export function ViewBar({ viewport, measuring, onWhich, children }: {
  readonly viewport: Viewport;
  readonly measuring: Measuring;
  /** Asks which cycle makes the contour; null where there is none. */
  readonly onWhich: (() => void) | null;
  /** What stands between the switches and the zoom. */
  readonly children: React.ReactNode;
}) {
  const t = useTexts().lathe, section = useSettings((s) => s.section), down = useSettings((s) => s.xDown);
  const paths = useSettings((s) => s.paths), colours = useSettings((s) => s.colours), solid = useSettings((s) => s.solid);
  return (
    <Toolbar className="lathe-viewbar" aria-label={t.viewTools}>
      <label className="lathe-section">
        <span className="unseen">{t.sections.title}</span>
        <select className="select" title={t.sections.title} value={solid ? "solid" : section} onChange={({ target: { value } }) =>
          changeSettings({ solid: value === "solid", section: SECTION_VIEWS.find((each) => each === value) ?? section })}
        >
          {[...SECTION_VIEWS, "solid" as const].map((each) => <option key={each} value={each}>{t.sections[each]}</option>)}
        </select>
      </label>
      <GlyphButton glyph={down ? "xDown" : "xUp"} name={t.xDown} text={t.xDown} pressed={down} onPress={() =>
        changeSettings({ xDown: !down })} />
      <GlyphButton glyph="ruler" name={t.ruler} text={t.ruler} pressed={measuring.on} onPress={measuring.toggle} />
      <GlyphButton glyph="which" name={t.which} disabled={onWhich === null} onPress={() => onWhich?.()} />
      <div className="lathe-which">
        <label className="lathe-which-paths">
          <span className="unseen">{t.paths.title}</span>
          <select className="select" title={t.paths.title} value={paths} onChange={(event) =>
            changeSettings({ paths: SHOWN_PATHS.find((each) => each === event.target.value) ?? "all" })}
          >
            {SHOWN_PATHS.map((each) => <option key={each} value={each}>{t.paths[each]}</option>)}
          </select>
        </label>
        <label className="lathe-which-paths">
          <span className="unseen">{t.colours.title}</span>
          <select className="select" title={t.colours.title} value={colours} onChange={(event) =>
            changeSettings({ colours: SHOWN_COLOURS.find((each) => each === event.target.value) ?? "none" })}
          >
            {SHOWN_COLOURS.map((each) => <option key={each} value={each}>{t.colours[each]}</option>)}
          </select>
        </label>
      </div>
      <div className="lathe-gap">{children}</div>
      <GlyphButton glyph="zoomOut" name={t.zoomOut} onPress={() => viewport.zoom(1 / ZOOM)} />
      <GlyphButton glyph="zoomIn" name={t.zoomIn} onPress={() => viewport.zoom(ZOOM)} />
      <GlyphButton glyph="fit" name={t.fit} onPress={viewport.fit} />
    </Toolbar>
  );
}
