import { encode } from "../document/encoding.ts";
import { downloadBytes } from "../base/download.ts";
import { fileOfJob, exportedText } from "../document/printed.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";

/** Downloads works that could not be saved, each as a program file. */
export function downloadWorks(works: readonly Work[]): void {
  for (const work of works) {
    if (isProgram(work)) {
      for (const { name, text, encoding } of textsOf(work)) downloadBytes(encode(text, encoding), name);
      continue;
    }
    void exportedText(work).then((text) => downloadBytes(encode(text, "utf-8"), fileOfJob(work)));
  }
}
