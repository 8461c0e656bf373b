import type { Shape } from "../shape.ts";

export const setup = {};

export type SetupTexts = Shape<typeof setup>;
