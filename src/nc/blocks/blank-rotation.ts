import type { Label, OutlineSource } from "../words.ts";
import { defineBlock } from "./define.ts";
import { outlineFields, outlineText, takeLabelBehind, takeOutline } from "./outline.ts";
import { CONE, program } from "./sample.ts";
import { choice, labelText, toolAxis, word } from "./words.ts";

const INNER = /LBL_?IN(?![A-Z_])/iy;

/** A blank as a contour revolved about the axis. */
export const blankRotation = defineBlock({
  kind: "blankRotation",
  keyword: "BLK FORM ROTATION",
  words: [
    toolAxis("axis", { compared: false }),
    choice("measure", ["D", "R"], { lead: "DIM_", otherwise: "D" }),
    word<"outline", OutlineSource, "blankSource" | "label" | "file">("outline", {
      take: takeOutline,
      text: (from) => ` ${outlineText(from)}`,
      fields: () => outlineFields<OutlineSource>(["label", "file"]),
    }),
    // The label of the inner contour.
    word<"inner", Label | null>("inner", {
      absent: null,
      take: (scan) => takeLabelBehind(scan, INNER) ?? undefined,
      text: (label) => (label === null ? "" : ` LBLIN ${labelText(label)}`),
    }),
  ],
  tags: ["blank", "opening"],
  part: "labels",
  offered: {
    group: "frame",
    begins: { kind: "blankRotation", axis: "Z", measure: "D", outline: { label: 1 }, inner: null },
  },
  sample: [
    ...program("> BLK FORM ROTATION Z DIM_D LBL 7", CONE).slice(0, -1),
    "LBL 7",
    "L X+0 Z+1",
    "L X+50",
    "L Z-30",
    "L X+56",
    "L Z-60",
    "L X+0",
    "LBL 0",
    "END PGM SAMPLE MM",
  ],
});
