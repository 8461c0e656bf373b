import { readFile } from "./file-reader.ts";
import { ISO } from "./iso-dialect.ts";
import { KLARTEXT } from "./klartext-dialect.ts";
import type { FileRefusal, LoadingControl } from "./refusal.ts";

/**
 * The refusals of a control when it loads a program file, in line order; empty for an accepted file. The grammar
 * follows the input formats and block rules of the manuals and shares no code with the reader and the printer, so that
 * it can check both. It refuses only what is certain: where the manuals say nothing, it accepts. Each block is refused
 * for its first fault only. Any text is read in linear time, and nothing throws.
 */
export function refusals(text: string, control: LoadingControl): readonly FileRefusal[] {
  return readFile(text, control === "iso" ? ISO : KLARTEXT);
}
