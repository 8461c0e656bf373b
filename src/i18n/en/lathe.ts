import type { Shape } from "../shape.ts";

export const lathe = {};

export type LatheTexts = Shape<typeof lathe>;
