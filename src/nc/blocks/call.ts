import { unsigned } from "../print-words.ts";
import type { Label, Parameter, Value } from "../words.ts";
import { PARAMETER, readLabel, VALUE } from "../value.ts";
import { defineBlock } from "./define.ts";
import { cut } from "./sample.ts";
import { labelField, labelText, word } from "./words.ts";

const LABEL = new RegExp(String.raw`(?:(\d{1,9})|"([^"]*)"|(${PARAMETER}))`, "iy");
const REPEAT = new RegExp(String.raw`REP[ \t]*(${VALUE})(?:[ \t]*/[ \t]*\d+)?`, "iy");

/** Calls a subprogram, or repeats a program section. */
export const call = defineBlock({
  kind: "call",
  keyword: "CALL LBL",
  words: [
    word<"label", Label | Parameter, "label">("label", {
      take: (scan) => {
        const m = scan.take(LABEL);
        if (!m) return undefined;
        return m[3] === undefined ? readLabel(m[1], m[2]) : { parameter: m[3].toUpperCase(), negative: false };
      },
      text: (name, style) => ` ${typeof name === "object" ? unsigned(name, style) : labelText(name)}`,
      compareAs: (name, said) => void said.label("LBL", name),
      fields: () => [labelField()],
    }),
    word<"repeat", Value | null, "repeat">("repeat", {
      absent: null,
      take: (scan) => {
        const m = scan.take(REPEAT);
        return m ? scan.value(m[1] ?? "") : undefined;
      },
      text: (times, style) => (times === null ? "" : ` REP ${unsigned(times, style)}`),
      compareAs: (times, said) => void said.number("REP", times),
      fields: () => [
        {
          id: "repeat",
          name: "repeat",
          letter: "REP",
          spread: { plus: [-2, 3] },
          entry: "value",
          get: (times) => times,
          put: (_, times) => times,
        },
      ],
    }),
  ],
  tags: ["calls"],
  part: "labels",
  offered: { group: "order", begins: { kind: "call", label: 1, repeat: null } },
  sample: cut(
    "L X+50 Z+2 FMAX",
    "LBL 1",
    "L IX-3 FMAX",
    "L Z-20 F0.25",
    "L IX+2",
    "L Z+2 FMAX",
    "L IX-2",
    "> CALL LBL 1 REP3",
  ),
});
