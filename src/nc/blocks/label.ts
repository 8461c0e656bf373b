import type { Label } from "../words.ts";
import { readLabel, TEXT_PARAMETER } from "../value.ts";
import { defineBlock } from "./define.ts";
import { plainLabel } from "./compared-words.ts";
import { CONE, cut } from "./sample.ts";
import { labelField, labelText, word } from "./words.ts";

const LABEL = new RegExp(String.raw`(?:(\d{1,9})|"([^"]*)"|(${TEXT_PARAMETER}))`, "iy");

/** A label for calls and jumps; `LBL 0` ends a subprogram. */
export const label = defineBlock({
  kind: "label",
  keyword: "LBL",
  words: [
    word<"label", Label, "label">("label", {
      take: (scan) => {
        const m = scan.take(LABEL);
        return m ? readLabel(m[1], m[2] ?? m[3]) : undefined;
      },
      text: (name, style) => `${name !== 0 && style.wide ? "  " : " "}${labelText(name)}`,
      compareAs: (name, said) => void said.label("LBL", name),
      fields: () => [labelField<Label>()],
    }),
  ],
  nameKey: (s) => `label ${plainLabel(s.label)}`,
  part: "labels",
  offered: { group: "order", begins: { kind: "label", label: 1 } },
  sample: cut("> LBL 1", ...CONE, "L X+58", "LBL 0"),
});
