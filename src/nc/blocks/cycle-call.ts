import { noWords } from "../words.ts";
import { defineBlock } from "./define.ts";
import { feedField, functionsField, pathWords } from "./path-words.ts";
import { cut } from "./sample.ts";
import { choiceField, word } from "./words.ts";

type How = "" | "POS" | "PAT";
const HOW = /(POS|PAT)(?![A-Z])/iy;

/** Runs the defined cycle: here, at a position, or at the points of a pattern. */
export const cycleCall = defineBlock({
  kind: "cycleCall",
  keyword: "CYCL CALL",
  begins: String.raw`CYCLE?[ \t]*CALL(?![A-Z_])`,
  words: [
    word<"how", How, "how">("how", {
      absent: "",
      take: (scan) => scan.take(HOW)?.[1]?.toUpperCase() as How | undefined,
      text: (how) => (how === "" ? "" : ` ${how}`),
      compareAs: (how, said) => void (how !== "" && said.put("", how)),
      fields: () => [
        choiceField<How, "how">(
          "how",
          ["here", "POS", "PAT"],
          (how) => (how === "" ? "here" : how),
          (chosen) => (chosen === "POS" || chosen === "PAT" ? chosen : ""),
          { noPicture: "choice" },
        ),
      ],
    }),
    pathWords(() => [feedField, functionsField], { wide: false }),
  ],
  tags: ["calls", "endsContour"],
  offered: { group: "cycles", begins: { kind: "cycleCall", how: "", words: noWords } },
  sample: cut("> CYCL CALL"),
});
