import { noWords } from "../../nc/words.ts";
import { programText } from "../../nc/print.ts";
import { LAYOUTS } from "../../nc/style.ts";
import type { BlankDraft } from "./job.ts";
import { blankStatement, nameOnControl } from "./print-job.ts";

/** A complete program with a blank, where one is stated, and no operation. */
export function emptyProgram(typedName: string, blank: BlankDraft | null): string {
  const name = nameOnControl(typedName);
  return programText(
    [
      { kind: "begin", name, unit: "MM" },
      ...(blank ? [blankStatement(blank)] : []),
      { kind: "mode", mode: "TURN", kinematics: null },
      {
        kind: "functions",
        words: { ...noWords, functions: [30] },
      },
      { kind: "end", name, unit: "MM" },
    ],
    LAYOUTS.tnc7,
  );
}
