import { wordsText } from "../print-words.ts";
import { noWords } from "../words.ts";
import { defineBlock, type Field } from "./define.ts";
import { functionsField, pathWords } from "./path-words.ts";
import { CONE, cut, instead } from "./sample.ts";
import type { Words } from "../words.ts";

const shown = {
  ...functionsField,
  spread: { swap: ["M136", "M137"] },
} satisfies Field<Words, "functions">;

/** M functions without a path. */
export const functions = defineBlock({
  kind: "functions",
  begins: String.raw`(?=M\d)`,
  words: [pathWords(() => [shown])],
  print: (s, style) => wordsText(s.words, style).trimStart(),
  offered: { group: "technology", begins: { kind: "functions", words: { ...noWords, functions: [136] } } },
  sample: instead(cut(...CONE), "M136", "> M136"),
});
