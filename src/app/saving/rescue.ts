import { encode } from "../editor/encoding.ts";
import { downloadBytes } from "../files/download.ts";
import { printedText, programName } from "../printed.ts";
import { isProgram, type Work } from "../work.ts";

/** Hands works that the device does not keep to the downloads, each as a program file. */
export function downloadWorks(works: readonly Work[]): void {
  for (const work of works) {
    const text = isProgram(work) ? work.text : printedText(work);
    downloadBytes(encode(text, isProgram(work) ? work.encoding : "utf-8"), isProgram(work) ? work.name : `${programName(text)}.h`);
  }
}
