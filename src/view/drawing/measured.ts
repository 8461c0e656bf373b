import type { Camera, Size } from "../camera.ts";
import { middleOf, type LabelBox } from "../dimensions/labels.ts";
import { DIMENSION_TEXT, placedDimensions, type DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { onPaperGrid } from "../dimensions/strokes.ts";
import { FIGURES, writtenAt, type Drawn } from "./paper.ts";

function frameOf({ x, y, width, height }: LabelBox): string {
  const r = height / 2,
    long = width - height;
  return `M${onPaperGrid(x + r)} ${onPaperGrid(y)}h${onPaperGrid(long)}a${onPaperGrid(r)} ${onPaperGrid(r)} 0 0 1 0 ${onPaperGrid(height)}h${onPaperGrid(-long)}a${onPaperGrid(r)} ${onPaperGrid(r)} 0 0 1 0 ${onPaperGrid(
    -height,
  )}Z`;
}

/** Free edge of the drawing, mm on paper. */
const EDGE = 1;

/**
 * Measurements on a drawing of both halves of a part, clear of the drawing's texts, each text in a frame with round ends,
 * as drawings mark inspected dimensions. Lengths in mm on paper.
 */
export function measuredOnPaper(
  measured: readonly DimensionRequest[],
  camera: Camera,
  size: Size,
  kept: readonly LabelBox[],
): Drawn {
  const room = { x: EDGE, y: EDGE, width: size.width - EDGE - EDGE, height: size.height - EDGE - EDGE };
  const placed = placedDimensions({ camera, unit: FIGURES / DIMENSION_TEXT, size, room, kept }, measured);
  const texts = new Map(measured.map(({ key, text }) => [key, text]));
  return {
    shapes: placed.flatMap(({ lines, arrows, box }) => [
      { role: "thin", d: lines } as const,
      { role: "arrow", d: arrows } as const,
      { role: "measured", d: frameOf(box) } as const,
    ]),
    texts: placed.map(({ key, box }) => writtenAt({ text: texts.get(key) ?? "" }, middleOf(box), false)),
    omitted: measured.length - placed.length,
  };
}
