import type { Shape } from "../shape.ts";

export const messages = {};

export type MessagesTexts = Shape<typeof messages>;
