import { cycleByNumber } from "../../../cycles/index.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import { ncLanguageOf, type Language } from "../../../i18n/languages.ts";
import type { Program } from "../../../nc/program.ts";
import { withBlocks } from "../../../nc/replace.ts";
import type { Statement } from "../../../nc/statement.ts";
import type { Label } from "../../../nc/words.ts";
import { blocksOfStatements } from "../../../program/edits/operation-edits.ts";

/** Adds an empty contour under a label at the end of the program; null if the cycle takes no contour. */
export function withContour(program: Program, number: number, label: Label): Program | null {
  if (cycleByNumber(number)?.contour !== "free") return null;
  const statements: readonly Statement[] = [
    { kind: "label", label },
    { kind: "label", label: 0 },
  ];
  const { blocks } = program;
  const end = blocks.findLastIndex(({ statement: s }) => s.kind === "end");
  const at = end < 0 ? blocks.length : end;
  return withBlocks(program, [
    ...blocks.slice(0, at),
    ...blocksOfStatements(program, at, statements),
    ...blocks.slice(at),
  ]);
}

/** Inserts cycle 14 with a label before the block at `index`. */
export function withContourNamed(program: Program, index: number, label: number, language: Language): Program {
  const { title, label: word } = ncLabels(ncLanguageOf(language)).contour;
  const named: readonly Statement[] = [
    { kind: "cycleLine", cycle: 14, line: 0, text: title },
    {
      kind: "cycleLine",
      cycle: 14,
      line: 1,
      text: `${word}${label}`,
    },
  ];
  const { blocks } = program;
  return withBlocks(program, [
    ...blocks.slice(0, index),
    ...blocksOfStatements(program, index, named),
    ...blocks.slice(index),
  ]);
}
