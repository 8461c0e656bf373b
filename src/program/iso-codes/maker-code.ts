import { readGrooveCode } from "./groove-insert.ts";
import type { MakerCode } from "./maker-code-shape.ts";
import { readThreadCode } from "./thread-insert.ts";

/** Reads the designation of a maker, in capital letters; null for a family that is not known. */
export const readMakerCode = (text: string): MakerCode | null => readThreadCode(text) ?? readGrooveCode(text);
