import { takeCycleNumber } from "../read-cycle.ts";
import type { Label, Parameter } from "../words.ts";
import { PARAMETER } from "../value.ts";
import { defineBlock } from "./define.ts";
import { plainLabel, plainText } from "./compared-words.ts";
import { property, takeRest, textField } from "./words.ts";

/** The cycle that names the labels of a contour. */
export const CONTOUR_CYCLE = 14;
/** The cycle that names a program. */
export const PROGRAM_CYCLE = 12;

const NAMED = new RegExp(String.raw`"([^"]+)"|(?<![A-Z])(${PARAMETER})|(\d{1,9})`, "gi");
/** The contour labels of cycle 14, after a word of any language: LABEL2, KONTURLABEL1 /2, LABEL QS3. */
export const contourLabels = (text: string): (Label | Parameter)[] =>
  [...text.matchAll(NAMED)].map(([, name, parameter, digits]) =>
    parameter === undefined ? (name ?? Number(digits)) : { parameter: parameter.toUpperCase(), negative: false },
  );

/**
 * Words of four and more letters in the lines of an older cycle depend on the language: CONTOUR LABEL, KONTURLABEL,
 * WINKEL.
 */
const LANGUAGE_WORD = /(?<![A-Z.\\:_])[A-Z.]{4,}(?![\\:_])/gi;

/** One of the numbered lines of an older cycle: 14.0, 14.1 … */
export const cycleLine = defineBlock({
  kind: "cycleLine",
  keyword: "CYCL DEF",
  begins: String.raw`CYCLE?[ \t]*DEF(?![A-Z_])`,
  words: [
    property<number>()("cycle"),
    property<number>()("line"),
    property<string>()("text", {
      fields: () => [
        textField<string, "cycleLine">(
          "cycleLine",
          (text) => text,
          (typed) => typed,
          { wide: true },
        ),
      ],
    }),
  ],
  read({ scan }) {
    const number = takeCycleNumber(scan);
    return number && number.line !== null
      ? { kind: "cycleLine", cycle: number.cycle, line: number.line, text: takeRest(scan) }
      : null;
  },
  print: (s, style) => `CYCL DEF ${s.cycle}.${s.line}${s.text === "" ? "" : `${style.wide ? "  " : " "}${s.text}`}`,
  pairKey: (s) => `cycleLine ${s.cycle}`,
  nameKey: (s) => `cycleLine ${s.cycle}.${s.line}`,
  compareAs({ cycle, line, text }, said) {
    // The first line only names the cycle.
    if (line === 0) said.put("", "");
    else if (cycle === CONTOUR_CYCLE) said.put("", contourLabels(text).map(plainLabel).join(" "));
    else said.put("", plainText(cycle === PROGRAM_CYCLE ? text : text.replace(LANGUAGE_WORD, " ")));
  },
  part: "labels",
  nameOf: (s) => (s.cycle === CONTOUR_CYCLE ? "contour" : "cycleLine"),
  names: {
    contour: {
      offered: {
        group: "contour",
        begins: ({ contourLabel }) => ({ kind: "cycleLine", cycle: CONTOUR_CYCLE, line: 1, text: `${contourLabel}2` }),
      },
    },
    cycleLine: {},
  },
});
