import { defineBlock } from "./define.ts";
import { CONE, cut } from "./sample.ts";
import { choiceField, value, word } from "./words.ts";

const VCONST = /VCONST[ \t]*(?::[ \t]*)?(ON|OFF)(?![A-Z])/iy;
const FACE = ["L X+40 Z+1 FMAX", "L X+2 F0.2", "L Z+3 FMAX"];

/** The turning spindle: constant cutting speed up to a limit, or constant rpm. */
export const spin = defineBlock({
  kind: "spin",
  keyword: "FUNCTION TURNDATA SPIN",
  words: [
    word<"constantSurface", boolean, "constantSurface">("constantSurface", {
      absent: false,
      needed: "VCONST",
      take: (scan) => {
        const m = scan.take(VCONST);
        return m ? m[1]?.toUpperCase() === "ON" : undefined;
      },
      text: (on) => ` VCONST:${on ? "ON" : "OFF"}`,
      compareAs: (on, said) => void said.put("VCONST", on ? "ON" : "OFF"),
      fields: () => [
        {
          ...choiceField<boolean, "constantSurface">(
            "constantSurface",
            ["on", "off"],
            (on) => (on ? "on" : "off"),
            (chosen) => chosen === "on",
          ),
          letter: "VCONST",
        },
      ],
    }),
    value("cuttingSpeed", "VC", {
      plain: true,
      colon: "written",
      unit: "m/min",
      spread: { times: [0.5, 2] },
      setup: "spindle.cuttingSpeed",
    }),
    value("speed", "S", { plain: true, colon: "read", spread: { times: [0.5, 2] }, setup: "spindle.speed" }),
    value("limit", "SMAX", {
      name: "speedLimit",
      plain: true,
      colon: "read",
      spread: { times: [0.3, 2] },
      setup: "spindle.limit",
    }),
    // The gear range of the spindle.
    value<"gear", never>("gear", "GEARRANGE", { plain: true, colon: "written", field: false }),
  ],
  tags: ["preparesCycle", "preparesTool", "leadsTool", "ofTool"],
  offered: {
    group: "technology",
    begins: { kind: "spin", constantSurface: true, cuttingSpeed: 180, speed: null, limit: 2500, gear: null },
  },
  sample: cut("> FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500", ...FACE),
  samples: {
    constantSurface: cut("> FUNCTION TURNDATA SPIN VCONST:ON VC:180 S790 SMAX2500", ...FACE),
    speed: cut("> FUNCTION TURNDATA SPIN VCONST:OFF S790", ...CONE),
  },
});
