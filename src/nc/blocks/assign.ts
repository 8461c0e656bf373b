import { assignmentText } from "../print-formula.ts";
import { readAssignment, type Assignment } from "../read-formula.ts";
import type { Formula, FunctionNumber } from "../words.ts";
import { NUMBER_PARAMETER } from "../value.ts";
import { defineBlock, within, type Field } from "./define.ts";
import { BARE, plainText } from "./compared-words.ts";
import { cut } from "./sample.ts";
import { property, textField } from "./words.ts";

const TARGET = new RegExp(String.raw`^\s*${NUMBER_PARAMETER}\s*$`, "i");
const rightSide = (text: string) => text.replace(/^[^=]*=\s*/, "");

type Assign = Assignment & { readonly kind: "assign" };
const fields: readonly Field<Assign, "target" | "formula">[] = [
  within(
    textField<string, "target">(
      "target",
      (target) => target,
      (typed) => (TARGET.test(typed) ? typed.trim().toUpperCase() : undefined),
      { noPicture: "name" },
    ),
    (s: Assign) => s.target,
    (s, target) => ({ ...s, target }),
  ),
  {
    id: "formula",
    name: "formula",
    wide: true,
    spread: { plus: [-4, 4] },
    entry: "line",
    shown: rightSide,
    line: (s, typed) => `${s.fn === null ? "" : `FN ${s.fn}: `}${s.target} = ${typed}`,
    keeps: true,
  },
];

/** Assigns a value to a Q parameter. `fn`: the number of the FN function, null for a formula. */
export const assign = defineBlock({
  kind: "assign",
  begins: String.raw`(?=FN[ \t]*(?:[0-8]|13)[ \t]*:|${NUMBER_PARAMETER}[ \t]*=)`,
  words: [property<FunctionNumber | null>()("fn"), property<string>()("target"), property<Formula>()("formula")],
  read: ({ scan }) => {
    const read = readAssignment(scan);
    return read && { kind: "assign", ...read };
  },
  print: assignmentText,
  fields: () => fields,
  nameKey: (s) => `assign ${s.target}`,
  // FN 0 only sets, as a formula of one value does.
  compareAs: (s, said) =>
    void said.put(
      s.target,
      plainText(assignmentText(s.fn === 0 ? { ...s, fn: null } : s, BARE).replace(/^[^=]*=/, "")),
    ),
  tags: ["preparesCycle", "preparesTool"],
  offered: {
    group: "order",
    begins: { kind: "assign", fn: null, target: "Q1", formula: { kind: "value", value: 0 } },
  },
  sample: cut("> FN 0: Q1 =+42", "L X+Q1 Z+2 FMAX", "L Z-25 F0.25"),
});
