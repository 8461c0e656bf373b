import { unsigned } from "../print-words.ts";
import type { Label, Parameter } from "../words.ts";
import { PARAMETER, parameterOf } from "../value.ts";
import { defineBlock } from "./define.ts";
import { CONE, cut, instead } from "./sample.ts";
import { extra, feed, labelText, optionalToolAxis, takeTool, value, word } from "./words.ts";

const HELD = new RegExp(String.raw`[+-]?[ \t]*${PARAMETER}`, "iy");

/** `TOOL CALL 5 Z S3000 F200 DL+0.1 DR+0.05`; without a tool only the speed, feed or deltas change. */
export const toolCall = defineBlock({
  kind: "toolCall",
  keyword: "TOOL CALL",
  words: [
    word<"tool", Label | Parameter | null, "tool">("tool", {
      absent: null,
      take: (scan) => {
        const direct = takeTool(scan);
        const parameter = direct === null ? scan.take(HELD) : null;
        return direct ?? (parameter ? parameterOf(parameter[0]) : undefined);
      },
      text: (tool, style) =>
        tool === null ? "" : ` ${typeof tool === "object" ? unsigned(tool, style) : labelText(tool)}`,
      compareAs: (tool, said) => void (tool !== null && said.label("T", tool)),
      fields: () => [
        {
          id: "tool",
          name: "tool",
          letter: "T",
          setup: "tool",
          spread: { tools: true },
          entry: "tool",
          get: (tool) => tool,
          put: (_, tool) => tool,
        },
      ],
    }),
    optionalToolAxis("axis"),
    value("speed", "S", { plain: true, noPicture: "milling" }),
    feed("feed"),
    value("deltaLength", "DL", { unit: "mm", noPicture: "milling" }),
    value("deltaRadius", "DR", { unit: "mm", noPicture: "milling" }),
    extra("extra"),
  ],
  nameKey: (s) => (s.tool === null ? "toolWords" : "toolCall"),
  tags: ["preparesTool", "endsContour"],
  part: "operations",
  offered: {
    group: "technology",
    begins: {
      kind: "toolCall",
      tool: 1,
      axis: null,
      speed: null,
      feed: null,
      deltaLength: null,
      deltaRadius: null,
      extra: [],
    },
  },
  sample: instead(cut(...CONE, "L Z-32"), "TOOL CALL 1", "> TOOL CALL 1 S1200"),
});
