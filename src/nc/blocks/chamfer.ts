import { unsigned } from "../print-words.ts";
import { noWords, type Value } from "../words.ts";
import { VALUE } from "../value.ts";
import { defineBlock } from "./define.ts";
import { feedField, pathWords } from "./path-words.ts";
import { cut, TO_CUT } from "./sample.ts";
import { word } from "./words.ts";

const BARE = new RegExp(VALUE, "iy");

/** A chamfer on the corner between two elements, by its side length. */
export const chamfer = defineBlock({
  kind: "chamfer",
  keyword: "CHF",
  words: [
    word<"length", Value | null, "chamfer">("length", {
      absent: null,
      needed: "CHF",
      take: (scan) => {
        const bare = scan.take(BARE);
        return bare ? scan.value(bare[0]) : undefined;
      },
      text: (length, style) => (length === null ? "" : `${style.wide ? "  " : " "}${unsigned(length, style)}`),
      compareAs: (length, said) => void said.put("", "CHF").number("LEN", length),
      fields: () => [
        {
          id: "chamfer",
          name: "chamfer",
          letter: "CHF",
          unit: "mm",
          spread: { times: [0.5, 2] },
          entry: "value",
          get: (length) => length,
          put: (_, length) => length,
        },
      ],
    }),
    pathWords(() => [feedField]),
  ],
  pairKey: () => "path",
  tags: ["waits"],
  offered: { group: "path", begins: { kind: "chamfer", length: 1, words: noWords } },
  sample: cut(...TO_CUT, "L Z-20", "> CHF 2", "L X+58"),
  samples: { feed: cut(...TO_CUT, "L Z-20", "> CHF 4 F0.1", "L X+58") },
});
