import type { Shape } from "../shape.ts";

export const cycles = {};

export type CyclesTexts = Shape<typeof cycles>;
