import { defineBlock } from "./define.ts";
import { property } from "./words.ts";

/** PLANE in all its forms, FUNCTION TCPM and its reset, stored as text and read at run time. */
export const plane = defineBlock({
  kind: "plane",
  begins: String.raw`PLANE(?![A-Z_])|FUNCTION(?=[ \t\u00a0]+(?:RESET[ \t]+)?TCPM(?![A-Z]))`,
  words: [property<string>()("text")],
  read({ scan, head }) {
    const text = `${head.toUpperCase()} ${scan.rest}`.trimEnd();
    scan.at = scan.text.length;
    return { kind: "plane", text };
  },
  print: (s) => s.text,
  isTypedAsText: () => true,
  tags: ["movesFrame"],
});
