import type { Shape } from "../shape.ts";

export const dialog = {};

export type DialogTexts = Shape<typeof dialog>;
