import { defineBlock, type Tag } from "./define.ts";
import { CONE, cut } from "./sample.ts";
import { property, takeRest, textField, word } from "./words.ts";

const NOTE = [
  "note",
  "preparesCycle",
  "preparesTool",
  "leadsTool",
  "leaves",
  "waits",
] as const satisfies readonly Tag[];

/** A line with nothing in it. */
export const empty = defineBlock({ kind: "empty", words: [], print: () => "", tags: NOTE });

/** `; a comment for the reader`. */
export const comment = defineBlock({
  kind: "comment",
  words: [
    property<string>()("text", {
      fields: () => [
        textField<string, "text">(
          "text",
          (text) => text,
          (typed) => typed,
          { wide: true, noPicture: "name" },
        ),
      ],
    }),
  ],
  print: (s) => `;${s.text}`,
  tags: NOTE,
  part: "notes",
  offered: { group: "notes", begins: { kind: "comment", text: " " } },
  sample: cut("> ; OUTSIDE", ...CONE),
});

/** `* - a structure item`. */
export const structure = defineBlock({
  kind: "structure",
  begins: String.raw`\*[ \t\u00a0]*-?`,
  words: [
    word<"text", string, "text">("text", {
      take: takeRest,
      text: (text) => text,
      fields: () => [
        textField<string, "text">(
          "text",
          (text) => text,
          (typed) => typed.trimStart(),
          { wide: true, noPicture: "name" },
        ),
      ],
    }),
  ],
  lead: () => "* - ",
  tags: NOTE,
  part: "notes",
  offered: { group: "notes", begins: { kind: "structure", text: "" } },
  sample: cut("> * - OUTSIDE", ...CONE),
});

/** A block that no kind reads. It stays unchanged. */
export const unknown = defineBlock({
  kind: "unknown",
  words: [property<string>()("text")],
  print: (s) => s.text,
  isTypedAsText: () => true,
  nameKey: (s) => `unknown ${/^\S*/.exec(s.text.toUpperCase())?.[0] ?? ""}`,
  part: "notes",
});
