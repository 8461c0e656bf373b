import { unsigned } from "../print-words.ts";
import type { Value } from "../words.ts";
import { readValue, VALUE } from "../value.ts";
import { defineBlock } from "./define.ts";
import { word } from "./words.ts";

const ERROR = new RegExp(String.raw`ERROR[ \t]*=?[ \t]*(${VALUE})`, "iy");

/** `FN 14: ERROR=1000`: the control stops with an error of this number. */
export const raise = defineBlock({
  kind: "raise",
  begins: String.raw`FN[ \t]*14[ \t]*:`,
  words: [
    word<"error", Value>("error", {
      take: (scan) => {
        const error = readValue(scan.take(ERROR)?.[1] ?? "x");
        return error !== null && scan.done ? error : undefined;
      },
      text: (error, style) => ` ERROR=${unsigned(error, style)}`,
    }),
  ],
  lead: () => "FN 14:",
  isTypedAsText: () => true,
});
