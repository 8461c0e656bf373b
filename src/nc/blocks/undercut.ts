import { defineBlock } from "./define.ts";
import { namedWords } from "./named-words.ts";
import { choiceField, word } from "./words.ts";

const FORM = /(TYPE[ \t]*_[ \t]*[A-Z]|THREAD)(?![A-Z])/iy;
/** The words of each form in the control's order. */
const WORDS: Readonly<Record<string, readonly string[]>> = {
  TYPE_E: ["R", "DEPTH", "BREADTH", "ANGLE"],
  TYPE_F: ["R", "DEPTH", "BREADTH", "ANGLE", "FACEDEPTH", "FACEANGLE"],
  TYPE_H: ["R", "BREADTH", "ANGLE"],
  TYPE_K: ["R", "DEPTH", "ROT", "ANGLE"],
  TYPE_U: ["R", "DEPTH", "BREADTH", "RND", "CHF"],
  THREAD: ["PITCH", "R", "DEPTH", "BREADTH", "ANGLE"],
};

/** An undercut in the corner of a contour. */
export const undercut = defineBlock({
  kind: "undercut",
  keyword: "UDC",
  words: [
    word<"form", string, "form">("form", {
      take: (scan) => scan.take(FORM)?.[1]?.replace(/[ \t]/g, "").toUpperCase(),
      text: (form) => ` ${form}`,
      compareAs: (form, said) => void said.put("", form),
      fields: () => [
        {
          ...choiceField<string, "form">(
            "form",
            Object.keys(WORDS),
            (form) => form,
            (chosen) => chosen,
          ),
          spread: { choices: ["TYPE_E", "TYPE_F", "TYPE_H"] },
        },
      ],
    }),
    namedWords(({ form }: { readonly form: string }) => WORDS[form] ?? []),
  ],
  offered: {
    group: "contour",
    begins: {
      kind: "undercut",
      form: "TYPE_E",
      words: [
        { name: "R", value: 1 },
        { name: "DEPTH", value: 2 },
        { name: "BREADTH", value: 15 },
      ],
    },
  },
  sample: "> UDC TYPE_F R0.8 DEPTH0.5 BREADTH4 ANGLE15 FACEDEPTH0.4 FACEANGLE8",
  samples: { form: "> UDC TYPE_E R0.8" },
});
