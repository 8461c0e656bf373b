import { textAssignmentText } from "../print-formula.ts";
import { readTextAssignment, TEXT_ASSIGNMENT } from "../read-text.ts";
import type { TextFormula } from "../words.ts";
import { defineBlock } from "./define.ts";
import { property } from "./words.ts";

/** Assigns a text to a QS parameter. `declared`: with DECLARE STRING. */
export const assignText = defineBlock({
  kind: "assignText",
  begins: `(?=${TEXT_ASSIGNMENT})`,
  words: [property<boolean>()("declared"), property<string>()("target"), property<TextFormula>()("text")],
  read: ({ scan }) => {
    const read = readTextAssignment(scan);
    return read && { kind: "assignText", ...read };
  },
  print: textAssignmentText,
  isTypedAsText: () => true,
  tags: ["preparesCycle", "preparesTool"],
});
