import { useTexts } from "../app/base/settings/use-texts.ts";
import { showContourView, useContourPlace } from "../app/place/contour-place.ts";

/** The picture in the middle while a contour is edited: its drawing or the lathe. */
export function ContourViews() {
  const t = useTexts().contour.views;
  const view = useContourPlace((p) => p.view);
  return (
    <div className="view-switch" role="group" aria-label={t.label}>
      {(["draw", "lathe"] as const).map((each) => (
        <button
          key={each}
          type="button"
          className="button"
          aria-pressed={view === each}
          onClick={() => showContourView(each)}
        >
          {t[each]}
        </button>
      ))}
    </div>
  );
}
