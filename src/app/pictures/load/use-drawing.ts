import { useMemo } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { drawingAlong, drawingOfSurface, type LoadDrawing } from "../../../view/load/lines.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { loadSize, useLoadOf, type LoadQuantity } from "./use-load.ts";

const EVERY = () => true;

/**
 * The lines of the colour map and their scale; null until known, or without a quantity. If paths are hidden the colours
 * show all moves.
 */
export function useLoadDrawing(
  run: Run,
  of: LoadQuantity | null,
  shown: (step: number) => boolean = EVERY,
): LoadDrawing | null {
  const { path, surface } = useLoadOf(run) ?? {};
  const paths = useSettings((s) => s.paths),
    has = paths === "none" ? EVERY : shown;
  const lengths = useLengths(run),
    size = of === null ? 1 : loadSize(lengths, of);
  return useMemo(() => {
    if (of === null) return null;
    if (of === "roughness") return surface ? drawingOfSurface(surface, size) : null;
    return path ? drawingAlong(path, of, run.steps, has, size) : null;
  }, [run, of, path, surface, has, size]);
}
