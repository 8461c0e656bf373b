import type { ContourChoice, Drawing, DrawingGiven, DrawingNote } from "../../program/drawing/drawing.ts";
import type { OpenedDrawing } from "../../app/document/drawing-request.ts";
import type { DrawingAnswers, DrawingQuestion } from "../../app/calculation/opened-drawing.ts";
import { LARGEST_DRAWING } from "../../program/drawing/endings.ts";
import { randomId } from "../../app/base/random-id.ts";
import { askAgain } from "../../app/calculation/worker-life.ts";

/** A drawing and the proposed choice, or notes that say why there is none. */
export type ReadDrawing =
  | { readonly kind: "drawing"; readonly name: string; readonly drawing: Drawing; readonly choice: ContourChoice }
  | { readonly kind: "failed"; readonly notes: readonly DrawingNote[] };

const failed = (note: DrawingNote): ReadDrawing => ({ kind: "failed", notes: [note] });

/** Reads a drawing in the worker, so that the page goes on; what the operator has given replaces what the file says. */
export async function readDrawingFile(file: File, given: DrawingGiven = {}): Promise<ReadDrawing> {
  if (file.size > LARGEST_DRAWING)
    return failed({ code: "tooLarge", severity: "error", values: { limit: LARGEST_DRAWING / 1e6 } });
  try {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const name = randomId(),
      read = await askAgain((engine) => engine.readDrawing(name, { name: file.name, bytes }, given));
    return read.drawing.curves.length > 0
      ? { kind: "drawing", name, ...read }
      : { kind: "failed", notes: read.drawing.notes };
  } catch {
    const kind = file.name.slice(file.name.lastIndexOf(".") + 1).toUpperCase();
    return failed({ code: "unreadable", severity: "error", values: { kind } });
  }
}

/** Asks the worker about a drawing; a new worker gets the drawing first. */
export async function askDrawing<Q extends DrawingQuestion>(
  { name, drawing }: Pick<OpenedDrawing, "name" | "drawing">,
  question: Q,
): Promise<DrawingAnswers[Q["ask"]]> {
  return await askAgain(async (engine) => {
    let answer = await engine.askDrawing(name, question);
    if (answer === null) {
      await engine.keepDrawing(name, drawing);
      answer = await engine.askDrawing(name, question);
    }
    return answer as DrawingAnswers[Q["ask"]];
  });
}
