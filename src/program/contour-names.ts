import type { Block } from "../nc/program.ts";
import type { Label } from "../nc/statement.ts";

/** Cycle 14 names the labels of the contour behind a word of any language: LABEL2, KONTURLABEL1 /2. */
export const contourLabels = (text: string): Label[] => [...text.matchAll(/"([^"]+)"|(\d{1,9})/g)].map((m) => m[1] ?? Number(m[2]));

/** The cycle that names the labels of a contour. */
export const CONTOUR_CYCLE = 14;

/** Labels that are outlines of contours or blanks, wherever in the program they are named. */
export function namesIn(blocks: readonly Block[]): Set<Label> {
  const names = new Set<Label>();
  for (const { statement: s } of blocks) {
    if (s.kind === "cycleLine" && s.cycle === CONTOUR_CYCLE && s.line > 0) { for (const label of contourLabels(s.text)) names.add(label); }
    else if (s.kind === "contourDefinition") {
      for (const { from } of s.areas) if ("label" in from && typeof from.label !== "object") names.add(from.label);
    } else if (s.kind === "blankRotation") {
      if ("label" in s.outline) names.add(s.outline.label);
      if (s.inner !== null) names.add(s.inner);
    } else if (s.kind === "turnBlank" && s.blank !== "off" && "label" in s.blank) names.add(s.blank.label);
  }
  return names;
}
