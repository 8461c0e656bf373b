import type { Shape } from "../shape.ts";

export const page = {};

export type PageTexts = Shape<typeof page>;
