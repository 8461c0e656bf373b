import { useEffect, useEffectEvent, useRef, useState } from "react";
import type { ContourChoice, DrawingGiven, DrawingNote, DrawnContour } from "../../program/drawing/drawing.ts";
import { keepDrawing, useDrawingRequest, type OpenedDrawing } from "../../app/document/drawing-request.ts";
import { askDrawing, readDrawingFile, type ReadDrawing } from "./read-drawing-file.ts";

/** State of the dialog: no file yet, reading, refused with the reasons, or a drawing with its choices. */
export type Opening =
  | { readonly kind: "choosing" }
  | { readonly kind: "reading"; readonly name: string }
  | { readonly kind: "refused"; readonly name: string; readonly notes: readonly DrawingNote[] }
  | { readonly kind: "open"; readonly opened: OpenedDrawing };

/** Reads the requested file, or continues with the last drawing. Only the newest request is answered. */
export function useOpenedDrawing(file: File | null) {
  const [done, setDone] = useState<{ readonly of: File | null; readonly opening: Opening }>(() => {
    const { last } = useDrawingRequest.getState();
    return { of: null, opening: last ? { kind: "open", opened: last } : { kind: "choosing" } };
  });
  const opening: Opening = file && done.of !== file ? { kind: "reading", name: file.name } : done.opening;
  const newest = useRef<Promise<ReadDrawing> | null>(null);
  const take = (opened: OpenedDrawing) => {
    keepDrawing(opened);
    setDone({ of: file, opening: { kind: "open", opened } });
  };
  const arrived = (chosen: File, result: ReadDrawing) => {
    if (result.kind === "failed")
      setDone({ of: file, opening: { kind: "refused", name: chosen.name, notes: result.notes } });
    else {
      const { name, drawing, choice } = result;
      take({ name, file: chosen, drawing, choice, proposed: choice });
    }
  };
  const came = useEffectEvent(arrived);
  useEffect(() => {
    if (!file) return undefined;
    const own = readDrawingFile(file);
    newest.current = own;
    void own.then((result) => newest.current === own && came(file, result));
    return () => void (newest.current = null);
  }, [file]);
  return {
    opening,
    /** Reads the drawing again in another unit, or another body of it; what was given before stays. */
    readAs: (given: DrawingGiven) => {
      if (opening.kind !== "open") return;
      const { file: chosen, drawing } = opening.opened,
        { unit, bodies } = drawing;
      const own = readDrawingFile(chosen, {
        ...(unit.source === "chosen" && { unit: unit.unit }),
        ...(bodies && { body: bodies.drawn }),
        ...given,
      });
      newest.current = own;
      void own.then((result) => newest.current === own && arrived(chosen, result));
    },
    change: (change: Partial<ContourChoice>) => {
      if (opening.kind === "open") take({ ...opening.opened, choice: { ...opening.opened.choice, ...change } });
    },
  };
}

/** A contour with the choice that it was made for. */
export interface MadeContour {
  readonly choice: ContourChoice;
  readonly contour: DrawnContour;
}

/** The contour of the newest choice; until it is made, that of the previous choice on the same drawing. */
export function useContour(opened: OpenedDrawing | null): MadeContour | null {
  const [made, setMade] = useState<(MadeContour & { readonly name: string }) | null>(null);
  const isBusy = useRef(false),
    waiting = useRef<OpenedDrawing | null>(null);
  useEffect(() => {
    // One question at a time: during a drag only the newest place is asked for.
    waiting.current = opened;
    if (isBusy.current) return;
    isBusy.current = true;
    void (async () => {
      for (let next = waiting.current; next; next = waiting.current) {
        waiting.current = null;
        const { name, choice } = next;
        try {
          const contour = await askDrawing(next, { ask: "contour", choice });
          setMade({ name, choice, contour });
        } catch {
          // The worker did not answer; the next choice asks again.
        }
      }
      isBusy.current = false;
    })();
  }, [opened]);
  return opened && made?.name === opened.name ? made : null;
}
