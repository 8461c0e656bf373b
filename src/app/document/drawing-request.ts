import { create } from "zustand";
import type { ContourRow } from "../../program/job/job.ts";
import type { ContourChoice, Drawing } from "../../program/drawing/drawing.ts";

/** A contour table that can take the contour of a drawing. */
export interface ContourTarget {
  /** Number of its elements, which the drawing replaces. */
  readonly count: number;
  /** Its program counts in inches. */
  readonly inches: boolean;
  /** Replaces all elements, as one step of undo. */
  readonly take: (rows: readonly ContourRow[]) => void;
}

/** A drawing that was opened, with the choices made on it. */
export interface OpenedDrawing {
  /** Name under which the worker keeps it. */
  readonly name: string;
  readonly file: File;
  readonly drawing: Drawing;
  readonly choice: ContourChoice;
  /** The reader's own choice, which stays visible as a proposal. */
  readonly proposed: ContourChoice;
}

/** The dialog that takes a contour from a drawing. */
export interface DrawingRequest {
  /** The chosen file; null continues with the last drawing. */
  readonly file: File | null;
  /** Null: the contour becomes a new program. */
  readonly target: ContourTarget | null;
}

interface Requests {
  readonly request: DrawingRequest | null;
  /** The tables on the page, the newest last: a dropped drawing goes there. */
  readonly targets: readonly { readonly now: () => ContourTarget }[];
  /** The last drawing: it stays for the session, so that its choices can be changed later. */
  readonly last: OpenedDrawing | null;
}

export const useDrawingRequest = create<Requests>(() => ({ request: null, targets: [], last: null }));
const { setState: set, getState: get } = useDrawingRequest;

/** Announces a table while it is on the page; returns its end. */
export function offerTarget(now: () => ContourTarget): () => void {
  const offered = { now };
  set(({ targets }) => ({ targets: [...targets, offered] }));
  return () => set(({ targets }) => ({ targets: targets.filter((each) => each !== offered) }));
}

/** Opens a drawing for a table, by default for the table on the page, else for a new program. */
export function openDrawing(
  file: File | null,
  target: ContourTarget | null = get().request?.target ?? get().targets.at(-1)?.now() ?? null,
): void {
  set({ request: { file, target } });
}

export const closeDrawing = (): void => set({ request: null });
export const keepDrawing = (last: OpenedDrawing): void => set({ last });
