import type { Label } from "../words.ts";
import { defineBlock } from "./define.ts";
import { CONE, cut, instead } from "./sample.ts";
import { labelText, shownLabel, takeTool, textField, typedLabel, value, word } from "./words.ts";

/** Length and radius of a tool in the program itself, for older controls. */
export const toolDefinition = defineBlock({
  kind: "toolDefinition",
  keyword: "TOOL DEF",
  words: [
    word<"tool", Label, "tool">("tool", {
      take: (scan) => takeTool(scan) ?? undefined,
      text: (tool) => ` ${labelText(tool)}`,
      compareAs: (tool, said) => void said.label("T", tool),
      fields: () => [textField<Label, "tool">("tool", shownLabel, typedLabel, { letter: "T", noPicture: "milling" })],
    }),
    // Read in this order only.
    { ...value("length", "L", { unit: "mm", noPicture: "milling" }), lettered: false },
    { ...value("radius", "R", { name: "toolRadius", unit: "mm", noPicture: "milling" }), lettered: false },
  ],
  nameKey: (s) => `toolDefinition ${s.tool}`,
  tags: ["preparesTool", "leadsTool"],
  offered: { group: "technology", begins: { kind: "toolDefinition", tool: 1, length: 0, radius: 0 } },
  sample: instead(cut(...CONE), "TOOL CALL 1", "> TOOL DEF 7 L+0 R+5", "TOOL CALL 1"),
});
