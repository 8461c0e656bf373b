import { defineBlock } from "./define.ts";
import { CONE, cut, instead } from "./sample.ts";
import { choice, takeQuoted, textField, word } from "./words.ts";

/** Switches to turning or milling, with named kinematics. */
export const mode = defineBlock({
  kind: "mode",
  keyword: "FUNCTION MODE",
  words: [
    choice("mode", ["TURN", "MILL"], { noPicture: "choice" }),
    word<"kinematics", string | null, "kinematics">("kinematics", {
      absent: null,
      take: (scan) => takeQuoted(scan) ?? undefined,
      text: (name) => (name === null ? "" : ` "${name}"`),
      fields: () => [
        textField<string | null, "kinematics">(
          "kinematics",
          (name) => name ?? "",
          (typed) => (typed.includes('"') ? undefined : typed === "" ? null : typed),
          { noPicture: "name" },
        ),
      ],
    }),
  ],
  tags: ["opening", "preparesTool", "leadsTool", "ofTool", "endsContour"],
  part: "operations",
  offered: { group: "technology", begins: { kind: "mode", mode: "TURN", kinematics: null } },
  sample: instead(cut(...CONE), "FUNCTION MODE TURN", "> FUNCTION MODE TURN"),
});
