import { unsigned } from "../print-words.ts";
import type { Scan } from "../scan.ts";
import type { ContourArea, OutlinePlace, Value } from "../words.ts";
import type { Style } from "../style.ts";
import { PARAMETER, readLabel, readValue, TEXT_PARAMETER, VALUE } from "../value.ts";
import { defineBlock } from "./define.ts";
import { named } from "./file-name.ts";
import { fileText, labelText, word } from "./words.ts";

/** The source of an outline, as part of a pattern. */
export const PLACE = String.raw`(?:(LBL[ \t]*)(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))|"([^"]*)"|(${TEXT_PARAMETER}))`;
const AREA = new RegExp(String.raw`([PIV])[ \t]*(\d{1,2})[ \t]*=?[ \t]*${PLACE}`, "iy");
const DEPTH = new RegExp(String.raw`DEPTH[ \t]*(${VALUE})`, "iy");

/** The outline source matched by PLACE. */
export function placeFrom([lbl, digits, name, label, file, text]: readonly (string | undefined)[]): OutlinePlace {
  if (lbl !== undefined) return { label: label === undefined ? readLabel(digits, name) : named(label) };
  return { file: text === undefined ? (file ?? "") : named(text) };
}
/** The depth of an area; null where not given. */
export function takeDepth(scan: Scan): Value | null {
  const depth = scan.take(DEPTH);
  return depth && readValue(depth[1] ?? "");
}
export function areaText({ from, depth }: Pick<ContourArea, "from" | "depth">, style: Style): string {
  const of =
    "file" in from
      ? fileText(from.file)
      : `LBL ${typeof from.label === "object" ? from.label.parameter : labelText(from.label)}`;
  return `${of}${depth === null ? "" : ` DEPTH${unsigned(depth, style)}`}`;
}

/** `CONTOUR DEF P1 = LBL 1 I2 = "PIN.H" DEPTH5`: the areas of a pocket, each by a label or a file. */
export const contourDefinition = defineBlock({
  kind: "contourDefinition",
  keyword: "CONTOUR DEF",
  begins: String.raw`CONTOUR[ \t]+DEF(?![A-Z])`,
  words: [
    word<"areas", readonly ContourArea[]>("areas", {
      take(scan) {
        const areas: ContourArea[] = [];
        for (let m = scan.take(AREA); m; m = scan.take(AREA)) {
          const role = (m[1] ?? "P").toUpperCase() as ContourArea["role"];
          areas.push({ role, number: Number(m[2]), from: placeFrom(m.slice(3)), depth: takeDepth(scan) });
        }
        return areas.length > 0 && scan.done ? areas : undefined;
      },
      text: (areas, style) => areas.map((a) => ` ${a.role}${a.number} = ${areaText(a, style)}`).join(""),
    }),
  ],
  // Apart from cycles the only block that a control writes on several lines.
  lines: "joined",
  isTypedAsText: () => true,
  tags: ["namesContour"],
});
