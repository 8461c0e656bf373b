import type { Pt } from "../../kernel/geometry/point.ts";
import type { ContourChoice, Drawing, DrawingGiven, DrawnContour } from "../../program/drawing/drawing.ts";
import { contourOf, propose, readDrawing, type DrawingFile } from "../../program/drawing/formats.ts";
import { picked, stepped, type ArrowKey, type Picked, type PickKind } from "../../program/drawing/pick.ts";

/*
 * A drawing in the worker, which reads it and makes its contours: a large one takes seconds. The worker keeps the last
 * one under its name; a new worker does not have it and answers null.
 */

const kept = new Map<string, Drawing>();

/** Keeps a drawing instead of the one before. */
export function keepDrawing(name: string, drawing: Drawing): void {
  kept.clear();
  kept.set(name, drawing);
}

/** A drawing with its proposed contour; what the operator has given replaces what the file says. */
export async function openedDrawing(
  name: string,
  file: DrawingFile,
  given: DrawingGiven = {},
): Promise<{ readonly drawing: Drawing; readonly choice: ContourChoice }> {
  const drawing = await readDrawing(file, given);
  keepDrawing(name, drawing);
  return { drawing, choice: propose(drawing) };
}

/** A question about the kept drawing. */
export type DrawingQuestion =
  | { readonly ask: "contour"; readonly choice: ContourChoice }
  | {
      readonly ask: "tap";
      readonly of: PickKind;
      readonly choice: ContourChoice;
      readonly at: Pt;
      /** Reach of the tap, mm. */
      readonly within: number;
    }
  | { readonly ask: "key"; readonly of: PickKind; readonly choice: ContourChoice; readonly key: ArrowKey }
  /** The likeliest choice with some of it given. */
  | { readonly ask: "proposal"; readonly given: Partial<ContourChoice> };

/** Answer to each question. */
export interface DrawingAnswers {
  readonly contour: DrawnContour;
  readonly tap: Picked;
  readonly key: Partial<ContourChoice> | "nothing";
  readonly proposal: ContourChoice;
}

/** Answers a question; null if the drawing is not kept here. */
export function askDrawing(name: string, question: DrawingQuestion): DrawingAnswers[DrawingQuestion["ask"]] | null {
  const drawing = kept.get(name);
  if (!drawing) return null;
  const read = (choice: ContourChoice) => contourOf(drawing, choice);
  switch (question.ask) {
    case "contour":
      return read(question.choice);
    case "tap":
      return picked(question.of, drawing, question.choice, question.at, question.within, read);
    case "key":
      return stepped(question.of, question.key, drawing, question.choice, read) ?? "nothing";
    case "proposal":
      return propose(drawing, question.given);
  }
}
