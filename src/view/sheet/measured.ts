import type { Camera } from "../camera.ts";
import type { LabelBox } from "../dimensions/labels.ts";
import { DIMENSION_TEXT, placedDimensions, type DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { onPaperGrid } from "../dimensions/strokes.ts";
import { FIGURES } from "./sizes.ts";

/**
 * A measurement on paper: its lines and arrows, and its text in a frame with round ends, as drawings mark inspected
 * dimensions.
 */
export interface PaperMeasurement {
  readonly lines: string;
  readonly arrows: string;
  readonly frame: string;
  readonly text: string;
  readonly box: LabelBox;
}

function frameOf({ x, y, width, height }: LabelBox): string {
  const r = height / 2,
    long = width - height;
  return `M${onPaperGrid(x + r)} ${onPaperGrid(y)}h${onPaperGrid(long)}a${onPaperGrid(r)} ${onPaperGrid(r)} 0 0 1 0 ${onPaperGrid(height)}h${onPaperGrid(-long)}a${onPaperGrid(r)} ${onPaperGrid(r)} 0 0 1 0 ${onPaperGrid(
    -height,
  )}Z`;
}

/** Free edge of the drawing, mm on paper. */
const EDGE = 1;

/** Measurements on a drawing of both halves of a part, clear of the drawing's texts. Lengths in mm on paper. */
export function measuredOnPaper(
  measured: readonly DimensionRequest[],
  paper: {
    readonly camera: Camera;
    readonly width: number;
    readonly height: number;
    readonly kept: readonly LabelBox[];
  },
): readonly PaperMeasurement[] {
  const { camera, width, height, kept } = paper;
  const room = { x: EDGE, y: EDGE, width: width - EDGE - EDGE, height: height - EDGE - EDGE };
  const sheet = { camera, unit: FIGURES / DIMENSION_TEXT, size: { width, height }, room, kept };
  const texts = new Map(measured.map(({ key, text }) => [key, text]));
  return placedDimensions(sheet, measured).map(({ key, lines, arrows, box }) => ({
    lines,
    arrows,
    frame: frameOf(box),
    text: texts.get(key) ?? "",
    box,
  }));
}
