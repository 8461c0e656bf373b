import type { Block } from "../../nc/program.ts";
import { CONTOUR_CYCLE, contourLabels } from "../../nc/blocks/cycle-line.ts";
import type { Label } from "../../nc/words.ts";

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
