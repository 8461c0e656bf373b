import type { Scan } from "../scan.ts";
import type { OutlinePlace, Value } from "../words.ts";
import { areaText, placeFrom, PLACE, takeDepth } from "./contour-definition.ts";
import { defineBlock } from "./define.ts";
import { property } from "./words.ts";

const CONTOUR = String.raw`QC\d{1,4}(?!\d)`;
const DECLARED = new RegExp(String.raw`DECLARE[ \t]+CONTOUR[ \t]+(${CONTOUR})[ \t]*=[ \t]*${PLACE}`, "iy");
const TARGET = new RegExp(String.raw`(${CONTOUR})[ \t]*=`, "iy");
const NAMED = new RegExp(CONTOUR, "iy");
const [JOIN, OPEN, CLOSE] = [/[|&^\\]/y, /\(/y, /\)/y] as const;
/** Longer formulas are refused: nobody writes them. */
const LONGEST = 200;

/** Contours with operators between them and matching brackets; null for anything else. */
function readTerms(scan: Scan): string[] | null {
  const terms: string[] = [];
  let open = 0;
  for (let wantsContour = true; !scan.done;) {
    const m = scan.take(wantsContour ? NAMED : JOIN) ?? scan.take(wantsContour ? OPEN : CLOSE);
    if (!m || terms.length >= LONGEST) return null;
    const term = m[0].toUpperCase();
    terms.push(term);
    if (term === "(") open += 1;
    else if (term === ")") open -= 1;
    else wantsContour = !wantsContour;
    if (open < 0) return null;
  }
  const last = terms.at(-1) ?? "";
  return open === 0 && (last === ")" || last.startsWith("QC")) ? terms : null;
}

/** A contour QC1 of a contour formula: `DECLARE CONTOUR QC1 = "POCKET.H" DEPTH5`. */
export const declareContour = defineBlock({
  kind: "declareContour",
  begins: String.raw`(?=DECLARE[ \t]+CONTOUR)`,
  words: [property<string>()("contour"), property<OutlinePlace>()("from"), property<Value | null>()("depth")],
  read({ scan }) {
    const declared = scan.take(DECLARED);
    const [, contour = "", ...place] = declared ?? [];
    const depth = declared && takeDepth(scan);
    return declared && scan.done
      ? { kind: "declareContour", contour: contour.toUpperCase(), from: placeFrom(place), depth }
      : null;
  },
  print: (s, style) => `DECLARE CONTOUR ${s.contour} = ${areaText(s, style)}`,
  isTypedAsText: () => true,
  tags: ["namesContour"],
});

/** Combines declared contours: `QC10 = ( QC1 | QC2 ) \ QC3`. */
export const contourFormula = defineBlock({
  kind: "contourFormula",
  begins: String.raw`(?=QC\d)`,
  words: [property<string>()("target"), property<readonly string[]>()("terms")],
  read({ scan }) {
    const target = scan.take(TARGET)?.[1]?.toUpperCase();
    const terms = target === undefined ? null : readTerms(scan);
    return target !== undefined && terms ? { kind: "contourFormula", target, terms } : null;
  },
  print: (s) => `${s.target} = ${s.terms.join(" ")}`,
  isTypedAsText: () => true,
  tags: ["namesContour"],
});
