import { useDrawingRequest, openDrawing } from "../../app/document/drawing-request.ts";
import { askForDrawing } from "../../app/records/files/ask-for-drawing.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Opens the last drawing with its choices, or asks for one; its contour goes into the table on the page. */
export function OpenDrawing() {
  const t = useTexts().contour;
  const hasLast = useDrawingRequest((r) => r.last !== null);
  const ask = async () => {
    const file = await askForDrawing();
    if (file) openDrawing(file);
  };
  return (
    <button type="button" className="button contour-details" onClick={() => (hasLast ? openDrawing(null) : void ask())}>
      <Icon name="drawing" /> {t.fromDrawing}
    </button>
  );
}
