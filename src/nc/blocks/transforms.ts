import { valueText } from "../number-text.ts";
import { unsigned } from "../print-words.ts";
import { axisName, readWords } from "../read-words.ts";
import type { AxisName, AxisWord, PolarWord, Value } from "../words.ts";
import type { Scan } from "../scan.ts";
import { VALUE } from "../value.ts";
import { defineBlock, within, type Field } from "./define.ts";
import { axesText, listFields } from "./path-words.ts";
import { CONE, cut } from "./sample.ts";
import { takeRest, word } from "./words.ts";

type Reset = "reset";
const RESET = /RESET(?![A-Z])/iy;
const takeReset = (scan: Scan): Reset | undefined => (scan.take(RESET) ? "reset" : undefined);
const AXIS = /AXIS(?![A-Z])/iy;
const LETTER = /([XYZABCUVW])(?![A-Z\d])/iy;
const TURNED = new RegExp(String.raw`(I?)ROT[ \t]*(${VALUE})`, "iy");
const SCALED = new RegExp(String.raw`SCL[ \t]*(${VALUE})`, "iy");

type Shift = readonly AxisWord[] | Reset;
const shiftFields = listFields.map((field) =>
  within(
    field,
    (shift: Shift) => (shift === "reset" ? [] : shift),
    (_, axes): Shift => axes,
  ),
);

/** `TRANS DATUM AXIS X+3 IZ-2`, and its end. */
export const datum = defineBlock({
  kind: "datum",
  keyword: "TRANS DATUM",
  words: [
    word<"shift", Shift, "x" | "y" | "z">("shift", {
      take: (scan) => takeReset(scan) ?? (scan.take(AXIS) ? readWords(scan).axes : undefined),
      text: (shift, style) => (shift === "reset" ? " RESET" : ` AXIS${axesText(shift, style)}`),
      compareAs: (shift, said) => void (shift === "reset" ? said.put("", "RESET") : said.axes(shift)),
      fields: () => shiftFields,
    }),
  ],
  isTypedAsText: (s) => s.shift === "reset",
  tags: ["movesFrame"],
  part: "labels",
  sample: cut("> TRANS DATUM AXIS X+0 Z-10", ...CONE),
});

/** `TRANS DATUM TABLE` with the row as it is written. */
export const datumTable = defineBlock({
  kind: "datumTable",
  keyword: "TRANS DATUM TABLE",
  begins: String.raw`TRANS[ \t]+DATUM[ \t\u00a0]*TABLE(?![A-Z])`,
  words: [word<"row", string>("row", { take: takeRest, text: (row) => (row === "" ? "" : ` ${row}`) })],
  isTypedAsText: () => true,
  tags: ["movesFrame"],
  part: "labels",
});

/** `TRANS MIRROR AXIS X`, and its end. */
export const mirror = defineBlock({
  kind: "mirror",
  keyword: "TRANS MIRROR",
  words: [
    word<"axes", readonly AxisName[] | Reset>("axes", {
      take(scan) {
        if (takeReset(scan)) return "reset";
        if (!scan.take(AXIS)) return undefined;
        const axes: AxisName[] = [];
        for (let m = scan.take(LETTER); m; m = scan.take(LETTER)) axes.push(axisName(m[1] ?? ""));
        return axes.length === 0 ? undefined : axes;
      },
      text: (axes) => (axes === "reset" ? " RESET" : ` AXIS ${axes.join(" ")}`),
    }),
  ],
  isTypedAsText: () => true,
  tags: ["movesFrame"],
  part: "labels",
});

/** The field of a value that a reset may replace. */
const changedField = <T>(
  letters: string,
  unit: { readonly unit?: string },
  get: (held: T) => Value | null,
  put: (held: T, value: Value) => T,
): Field<T, never> =>
  ({
    id: letters,
    name: { word: letters },
    ...unit,
    noPicture: "milling",
    entry: "value",
    get,
    put: (before: T, value: Value | null) => (value === null ? undefined : put(before, value)),
  }) as Field<T, never>;

/** `TRANS ROTATION ROT+30`, and its end. */
export const rotation = defineBlock({
  kind: "rotation",
  keyword: "TRANS ROTATION",
  words: [
    word<"angle", PolarWord | Reset>("angle", {
      take(scan) {
        const reset = takeReset(scan);
        const m = reset ? null : scan.take(TURNED);
        const value = m && scan.value(m[2] ?? "");
        return reset ?? (m && value !== null ? { value, incremental: m[1] !== "" } : undefined);
      },
      text: (angle, style) =>
        angle === "reset" ? " RESET" : ` ${angle.incremental ? "I" : ""}ROT${valueText(angle.value, style)}`,
      fields: () => [
        changedField<PolarWord | Reset>(
          "ROT",
          { unit: "°" },
          (angle) => (angle === "reset" ? null : angle.value),
          (angle, value) => (angle === "reset" ? angle : { ...angle, value }),
        ),
      ],
    }),
  ],
  isTypedAsText: (s) => s.angle === "reset",
  tags: ["movesFrame"],
  part: "labels",
  sample: cut("> TRANS ROTATION ROT+30"),
});

/** `TRANS SCALE SCL0.99`, and its end. */
export const scale = defineBlock({
  kind: "scale",
  keyword: "TRANS SCALE",
  words: [
    word<"factor", Value | Reset>("factor", {
      take(scan) {
        const reset = takeReset(scan);
        const m = reset ? null : scan.take(SCALED);
        return reset ?? (m ? (scan.value(m[1] ?? "") ?? undefined) : undefined);
      },
      text: (factor, style) => (factor === "reset" ? " RESET" : ` SCL${unsigned(factor, style)}`),
      fields: () => [
        changedField<Value | Reset>(
          "SCL",
          {},
          (factor) => (factor === "reset" ? null : factor),
          (_, factor) => factor,
        ),
      ],
    }),
  ],
  isTypedAsText: (s) => s.factor === "reset",
  tags: ["movesFrame"],
  part: "labels",
  sample: cut("> TRANS SCALE SCL0.99"),
});
