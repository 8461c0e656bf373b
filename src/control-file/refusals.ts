import { readFile } from "./file-reader.ts";
import { ISO } from "./iso-dialect.ts";
import { KLARTEXT } from "./klartext-dialect.ts";
import type { FileRefusal, LoadingControl } from "./refusal.ts";

/**
 * What a control refuses when it loads a program file, in the order of its lines; empty for a file that it takes. The
 * grammar is written from the input formats and block rules of the manuals and shares no code with the reader and the
 * printer, so that it can judge both. It refuses only what is certain: where the manuals say nothing, it accepts. A
 * block is refused for its first fault only. Any text is read in linear time, and nothing throws.
 */
export function refusals(text: string, control: LoadingControl): readonly FileRefusal[] {
  return readFile(text, control === "iso" ? ISO : KLARTEXT);
}
