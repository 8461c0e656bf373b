import type { Shape } from "../shape.ts";

export const contour = {};

export type ContourTexts = Shape<typeof contour>;
