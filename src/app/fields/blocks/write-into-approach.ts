import { withBlock } from "../../../nc/edit.ts";
import { startLines } from "../../../nc/program.ts";
import { approachContext } from "../../../program/edits/approach-context.ts";
import { approachDraft, approachStatement } from "../../../program/edits/approach-draft.ts";
import type { ApproachWord } from "../../../program/motion/approach-fields.ts";
import { positionAsTyped } from "../../../program/values/typed-value.ts";
import { parametersBefore } from "./block-context.ts";
import { editClosedText } from "./session.ts";

/** Writes a size, mm or degrees, of the APPR or DEP block whose prompts were open, while another page is shown. */
export const writeIntoApproach = (line: number, word: ApproachWord, size: number): void =>
  editClosedText((program) => {
    const index = startLines(program).indexOf(line),
      s = program.blocks[index]?.statement;
    if (s?.kind !== "approach") return program;
    const { plane, unit, parameters } = approachContext(program, index, null, parametersBefore(program, index));
    const before = approachDraft(s),
      sign = /^I/i.exec(before[word] ?? "")?.[0] ?? "";
    const text = sign + positionAsTyped(word === "CCA" || word === "PA" ? size : size / unit);
    return withBlock(program, index, approachStatement(s, plane, { ...before, [word]: text }, parameters));
  });
