import { defineBlock } from "./define.ts";
import { namedWords } from "./named-words.ts";
import { CONE, cut } from "./sample.ts";
import { choiceField, textField, word } from "./words.ts";

type System = "TCS" | "WPL";
const SYSTEM = /-[ \t]*(TCS|WPL)/iy;
const PLANE = /:[ \t]*([A-Z](?:[ \t]*\/[ \t]*[A-Z])?)(?![A-Z])/iy;

/** `FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1 DXL:0`. */
export const turnCorrection = defineBlock({
  kind: "turnCorrection",
  keyword: "FUNCTION TURNDATA CORR",
  words: [
    word<"system", System, "system">("system", {
      take: (scan) => {
        const m = scan.take(SYSTEM);
        return m ? (m[1]?.toUpperCase() === "WPL" ? "WPL" : "TCS") : undefined;
      },
      text: (system) => `-${system}`,
      compareAs: (system, said) => void said.put("", system),
      fields: () => [
        choiceField<System, "system">(
          "system",
          ["TCS", "WPL"],
          (system) => system,
          (chosen) => (chosen === "WPL" ? "WPL" : "TCS"),
          { noPicture: "choice" },
        ),
      ],
    }),
    word<"plane", string, "plane">("plane", {
      take: (scan) => scan.take(PLANE)?.[1]?.replace(/[ \t]/g, "").toUpperCase(),
      text: (plane) => `:${plane}`,
      compareAs: (plane, said) => void said.put("", plane),
      fields: () => [
        textField<string, "plane">(
          "plane",
          (plane) => plane,
          (typed) => (/^[A-Z](\/[A-Z])?$/i.test(typed.trim()) ? typed.trim().toUpperCase() : undefined),
          { noPicture: "choice" },
        ),
      ],
    }),
    namedWords(() => ["DZL", "DXL"], { colon: true }),
  ],
  tags: ["preparesTool", "ofTool"],
  offered: {
    group: "technology",
    begins: {
      kind: "turnCorrection",
      system: "TCS",
      plane: "Z/X",
      words: [
        { name: "DZL", value: 0 },
        { name: "DXL", value: 0 },
      ],
    },
  },
  sample: cut("> FUNCTION TURNDATA CORR-TCS:Z/X DZL:0 DXL:0", ...CONE),
});
