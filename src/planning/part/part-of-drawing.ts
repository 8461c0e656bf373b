import { drawnContour } from "../../program/drawing/contour-of.ts";
import type { ContourChoice, Drawing, DrawingNote } from "../../program/drawing/drawing.ts";
import { propose } from "../../program/drawing/propose.ts";
import { newPart, type FinishedPart } from "./finished-part.ts";
import { partRows } from "./part-rows.ts";

/** A part from a drawing, null where it has no contour, and what was left out, joined or assumed. */
export interface PartOfDrawing {
  readonly part: FinishedPart | null;
  readonly choice: ContourChoice;
  readonly notes: readonly DrawingNote[];
}

/**
 * The part of a drawing, with its outside and its bore in one go. Axis, half, zero point and piece are proposed where
 * they are not given.
 */
export function partOfDrawing(drawing: Drawing, name: string, given: Partial<ContourChoice> = {}): PartOfDrawing {
  const { side: _, ...asked } = given;
  const choice = { ...propose(drawing, asked), side: "outside" } as const,
    outside = drawnContour(drawing, choice),
    bore = outside.hasSides ? drawnContour(drawing, { ...choice, side: "bore" }) : null;
  const told = new Set(outside.notes.map((note) => JSON.stringify(note)));
  const notes = [
    ...drawing.notes,
    ...outside.notes,
    ...(bore?.notes ?? []).filter((note) => !told.has(JSON.stringify(note))),
  ];
  const rows = partRows(outside.rows, bore?.rows ?? []);
  return { part: rows.outside.length < 2 ? null : { ...newPart(name), ...rows }, choice, notes };
}
