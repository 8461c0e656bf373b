import type { Scan } from "../scan.ts";
import type { OutlineSource } from "../words.ts";
import { defineBlock } from "./define.ts";
import { outlineFields, outlineText, takeOutline } from "./outline.ts";
import { CONE, cut } from "./sample.ts";
import { word } from "./words.ts";

const OFF = /OFF(?![A-Z])/iy;
type Blank = OutlineSource | "off";
const takeBlank = (scan: Scan): Blank | undefined => takeOutline(scan) ?? (scan.take(OFF) ? "off" : undefined);

/** Blank update: the control tracks the outline of the work from cut to cut, or stops doing so. */
export const turnBlank = defineBlock({
  kind: "turnBlank",
  keyword: "FUNCTION TURNDATA BLANK",
  words: [
    word<"blank", Blank, "blankSource" | "label" | "file">("blank", {
      take: takeBlank,
      text: (blank) => ` ${blank === "off" ? "OFF" : outlineText(blank)}`,
      fields: () => outlineFields<Blank>(["off", "label", "file"]),
    }),
  ],
  // Text after it is not reported.
  read({ scan }) {
    const blank = takeBlank(scan);
    return blank === undefined ? null : { kind: "turnBlank", blank };
  },
  tags: ["opening", "preparesTool"],
  part: "labels",
  offered: { group: "technology", begins: { kind: "turnBlank", blank: { label: 1 } } },
  sample: cut("> FUNCTION TURNDATA BLANK OFF", ...CONE),
});
