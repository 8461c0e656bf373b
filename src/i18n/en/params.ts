import type { Shape } from "../shape.ts";

export const params = {};

export type ParamsTexts = Shape<typeof params>;
