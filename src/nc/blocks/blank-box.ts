import { readWords } from "../read-words.ts";
import type { AxisName, AxisWord } from "../words.ts";
import { defineBlock, type Field } from "./define.ts";
import { axesText, listFields } from "./path-words.ts";
import { CONE, program } from "./sample.ts";
import { property, optionalToolAxis, word } from "./words.ts";

type Axes = readonly AxisWord[];
const ALONE = /([XYZABCUVW])(?=[ \t]|$)/iy;
const toolAxisWord = optionalToolAxis("axis", ALONE, ["X", "Y", "Z"]);
/** Round the axis both corners lie on a ⌀ that is no coordinate. */
const cornerFields = listFields.map((field) =>
  field.id === "Z" ? field : ({ ...field, spread: { plus: [-8, 8] } } as Field<Axes, "x" | "y" | "z">),
);

/** One corner of a box as blank; the first names the axis of the spindle. */
export const blankBox = defineBlock({
  kind: "blankBox",
  begins: String.raw`BLK[ \t]+FORM[ \t\u00a0]*0[.,][12](?!\d)`,
  words: [
    property<1 | 2>()("corner"),
    {
      ...toolAxisWord,
      fields: (axis: AxisName | null, { corner }: { readonly corner: 1 | 2 }) =>
        corner === 1 ? (toolAxisWord.fields?.(axis, undefined as never) ?? []) : [],
    },
    word<"axes", Axes, "x" | "y" | "z">("axes", {
      take: (scan) => readWords(scan).axes,
      text: axesText,
      compareAs: (axes, said) => void said.axes(axes),
      fields: () => cornerFields,
    }),
  ],
  // The second corner names no axis.
  found: ({ head }) => (head.endsWith("1") ? { corner: 1 as const } : { corner: 2 as const, axis: null }),
  lead: (s) => `BLK FORM 0.${s.corner}`,
  nameKey: (s) => `blankBox ${s.corner}`,
  tags: ["blank", "opening"],
  offered: {
    group: "frame",
    begins: {
      kind: "blankBox",
      corner: 1,
      axis: "Z",
      axes: [
        { axis: "X", value: 0, incremental: false },
        { axis: "Y", value: 0, incremental: false },
        { axis: "Z", value: -20, incremental: false },
      ],
    },
  },
  sample: program("> BLK FORM 0.1 Z X-24 Y-24 Z-60\nBLK FORM 0.2 X+24 Y+24 Z+1", CONE),
});
