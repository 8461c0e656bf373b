import { encode } from "../document/encoding.ts";
import { downloadBytes } from "../base/download.ts";
import { exportedFiles } from "../document/printed.ts";
import type { Work } from "../document/work.ts";

/** Downloads works that could not be saved, each as a program file. */
export function downloadWorks(works: readonly Work[]): void {
  for (const work of works)
    void exportedFiles(work).then((files) => {
      for (const { name, text, encoding } of files) downloadBytes(encode(text, encoding), name);
    });
}
