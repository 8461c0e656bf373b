import { part } from "../../kernel/geometry/point.ts";
import type { Drawing, DrawingGiven, DrawingNote } from "./drawing.ts";
import { DRAWING_KINDS, kindOfName, LARGEST_DRAWING, type DrawingKind } from "./endings.ts";
import { withoutDoubles } from "./merge.ts";

export { drawnContour as contourOf } from "./contour-of.ts";
export { propose } from "./propose.ts";

/** A file as it was opened. */
export interface DrawingFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** A kind of drawing: its first bytes, and its reader, which is fetched on first use. */
interface Format {
  /** Whether the first characters of a file are of this kind, whatever its name. */
  readonly begins: RegExp;
  readonly load: () => Promise<(bytes: Uint8Array, given: DrawingGiven) => Drawing>;
}

const FORMATS: Readonly<Record<DrawingKind, Format>> = {
  DXF: {
    begins: /^(?:\uFEFF|ï»¿)?\s*(?:999\s|0\s+SECTION)|^AutoCAD Binary DXF/,
    load: async () => (await import("./dxf/read-dxf.ts")).readDxfFile,
  },
  STEP: {
    begins: /^(?:\uFEFF|ï»¿)?\s*(?:\/\*(?:[^*]|\*(?!\/))*\*\/\s*)*ISO-10303-21\s*;/,
    load: async () => (await import("./step/read-step.ts")).readStep,
  },
  SVG: {
    begins: /^(?:\uFEFF|ï»¿)?\s*<(?:[^]*[<: ])?svg[\s>]/,
    load: async () => (await import("./svg/read-svg.ts")).readSvg,
  },
};

const refused = (note: DrawingNote): Drawing => ({
  curves: [],
  unit: { unit: "mm", source: "assumed" },
  texts: [],
  tolerance: 0,
  notes: [note],
});

/** Lines drawn twice are one; a drawing without a unit says its size; one without lines is an error. */
function finished(drawing: Drawing): Drawing {
  if (drawing.notes.some((n) => n.severity === "error")) return drawing;
  const { curves, doubled } = withoutDoubles(drawing.curves);
  const notes: DrawingNote[] = [...drawing.notes];
  if (doubled > 0) notes.push({ code: "doubled", severity: "info", values: { count: doubled } });
  if (curves.length === 0) notes.unshift({ code: "nothing", severity: "error", values: {} });
  else if (drawing.unit.source === "assumed") {
    const boxes = curves.map((c) => part.boxOf(c.segment)),
      span = (low: (b: (typeof boxes)[number]) => number, high: (b: (typeof boxes)[number]) => number) =>
        boxes.reduce((most, b) => Math.max(most, high(b)), -Infinity) -
        boxes.reduce((least, b) => Math.min(least, low(b)), Infinity);
    const values = {
      width: span(
        (b) => b.left,
        (b) => b.right,
      ),
      height: span(
        (b) => b.low,
        (b) => b.high,
      ),
    };
    notes.unshift({ code: "unitAssumed", severity: "warning", values });
  }
  return { ...drawing, curves, notes };
}

/**
 * Reads a drawing of any known kind; what is given replaces what the file says. What cannot be read is a note of severity
 * error. Rejects only when the reader's code cannot be loaded.
 */
export async function readDrawing(file: DrawingFile, given: DrawingGiven = {}): Promise<Drawing> {
  const { bytes, name } = file;
  if (bytes.length > LARGEST_DRAWING)
    return refused({ code: "tooLarge", severity: "error", values: { limit: LARGEST_DRAWING / 1e6 } });
  const head = String.fromCharCode(...bytes.subarray(0, 400)),
    named = kindOfName(name),
    format = Object.values(FORMATS).find((f) => f.begins.test(head)) ?? (named && FORMATS[named]);
  if (!format) return refused({ code: "unknownKind", severity: "error", values: { kinds: DRAWING_KINDS } });
  const read = await format.load();
  return finished(read(bytes, given));
}
