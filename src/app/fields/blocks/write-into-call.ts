import { startLines } from "../../../nc/program.ts";
import type { OpenCall } from "../../place/open-call.ts";
import { withPrompt } from "./block-prompts.ts";
import { editClosedText } from "./session.ts";

/** Writes a value of the cycle block whose prompts were open, while another page is shown. */
export const writeIntoCall = ({ cycle, line }: Pick<OpenCall, "cycle" | "line">, q: string, text: string): void =>
  editClosedText((program) => {
    const index = startLines(program).indexOf(line),
      s = program.blocks[index]?.statement;
    return s?.kind === "cycle" && s.cycle === cycle ? withPrompt(program, index, q, text) : program;
  });
