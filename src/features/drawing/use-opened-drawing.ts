import { useEffect, useEffectEvent, useRef, useState } from "react";
import type { ContourChoice, DrawingNote } from "../../program/drawing/drawing.ts";
import { keepDrawing, useDrawingRequest, type OpenedDrawing } from "../../app/document/drawing-request.ts";
import { readDrawingFile } from "./read-drawing-file.ts";

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
  const newest = useRef(0);
  const take = (opened: OpenedDrawing) => {
    keepDrawing(opened);
    setDone({ of: file, opening: { kind: "open", opened } });
  };
  const read = async (chosen: File, unit?: "mm" | "inch") => {
    newest.current += 1;
    const own = newest.current,
      result = await readDrawingFile(chosen, unit);
    if (newest.current !== own) return;
    if (result.kind === "failed")
      setDone({ of: file, opening: { kind: "refused", name: chosen.name, notes: result.notes } });
    else take({ file: chosen, drawing: result.drawing, choice: result.choice, proposed: result.choice });
  };
  const begin = useEffectEvent(read);
  useEffect(() => {
    const count = newest;
    if (file) void begin(file);
    return () => void (count.current += 1);
  }, [file]);
  return {
    opening,
    /** Reads the drawing again in another unit. */
    readAs: (unit: "mm" | "inch") => {
      if (opening.kind === "open") void read(opening.opened.file, unit);
    },
    change: (change: Partial<ContourChoice>) => {
      if (opening.kind === "open") take({ ...opening.opened, choice: { ...opening.opened.choice, ...change } });
    },
  };
}
