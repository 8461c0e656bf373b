import { textAssignmentText } from "../print-formula.ts";
import { readTextAssignment, TEXT_ASSIGNMENT } from "../read-text.ts";
import type { TextFormula } from "../words.ts";
import { defineBlock } from "./define.ts";
import { held } from "./words.ts";

/** Assigns a text to a QS parameter. `declared`: with DECLARE STRING. */
export const assignText = defineBlock({
  kind: "assignText",
  begins: `(?=${TEXT_ASSIGNMENT})`,
  words: [held<boolean>()("declared"), held<string>()("target"), held<TextFormula>()("text")],
  read: ({ scan }) => {
    const read = readTextAssignment(scan);
    return read && { kind: "assignText", ...read };
  },
  print: textAssignmentText,
  asText: () => true,
  tags: ["preparesCycle", "preparesTool"],
});
