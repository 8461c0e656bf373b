import type { Shape } from "../shape.ts";

export const help = {};

export type HelpTexts = Shape<typeof help>;
