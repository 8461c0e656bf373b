import type { ContourTexts } from "../en/contour.ts";

export const contour = {} satisfies ContourTexts;
