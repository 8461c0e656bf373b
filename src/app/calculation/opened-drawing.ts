import type { ContourChoice, Drawing } from "../../program/drawing/drawing.ts";
import { propose, readDrawing, type DrawingFile } from "../../program/drawing/formats.ts";

/** A drawing with its proposed contour. `unit`: chosen by the operator, instead of that of the file. */
export async function openedDrawing(
  file: DrawingFile,
  unit?: "mm" | "inch",
): Promise<{ readonly drawing: Drawing; readonly choice: ContourChoice }> {
  const drawing = await readDrawing(file, unit);
  return { drawing, choice: propose(drawing) };
}
