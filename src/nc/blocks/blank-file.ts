import { defineBlock } from "./define.ts";
import { takeQuoted, word } from "./words.ts";

const TARGET = /TARGET(?![A-Z])/iy;

/** A body from a file as blank; `target`: the file of the finished part. */
export const blankFile = defineBlock({
  kind: "blankFile",
  keyword: "BLK FORM FILE",
  words: [
    word<"file", string>("file", { take: (scan) => takeQuoted(scan) ?? undefined, text: (file) => ` "${file}"` }),
    word<"target", string | null>("target", {
      absent: null,
      take: (scan) => (scan.take(TARGET) ? takeQuoted(scan) : undefined),
      text: (file) => (file === null ? "" : ` TARGET "${file}"`),
    }),
  ],
  isTypedAsText: () => true,
  tags: ["blank", "opening"],
  part: "labels",
});
