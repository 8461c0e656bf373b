import type { Block } from "../../nc/program.ts";
import type { Label, Parameter } from "../../nc/statement.ts";
import { PARAMETER } from "../../nc/value.ts";

const NAMED = new RegExp(String.raw`"([^"]+)"|(?<![A-Z])(${PARAMETER})|(\d{1,9})`, "gi");

/** Cycle 14 names the labels of the contour behind a word of any language: LABEL2, KONTURLABEL1 /2, LABEL QS3. */
export const contourLabels = (text: string): (Label | Parameter)[] =>
  [...text.matchAll(NAMED)].map(([, name, parameter, digits]) =>
    parameter === undefined ? (name ?? Number(digits)) : { parameter: parameter.toUpperCase(), negative: false },
  );

/** The cycle that names the labels of a contour. */
export const CONTOUR_CYCLE = 14;

/** Labels that are outlines of contours or blanks, wherever in the program they are named. */
export function namesIn(blocks: readonly Block[]): Set<Label> {
  const names = new Set<Label>();
  for (const { statement: s } of blocks) {
    if (s.kind === "cycleLine" && s.cycle === CONTOUR_CYCLE && s.line > 0) {
      for (const label of contourLabels(s.text)) if (typeof label !== "object") names.add(label);
    } else if (s.kind === "contourDefinition") {
      for (const { from } of s.areas) if ("label" in from && typeof from.label !== "object") names.add(from.label);
    } else if (s.kind === "blankRotation") {
      if ("label" in s.outline) names.add(s.outline.label);
      if (s.inner !== null) names.add(s.inner);
    } else if (s.kind === "turnBlank" && s.blank !== "off" && "label" in s.blank) names.add(s.blank.label);
  }
  return names;
}
