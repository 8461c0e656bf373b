import { withBlock } from "../../../nc/edit.ts";
import { startLines } from "../../../nc/program.ts";
import { fieldsOf } from "./block-fields.ts";
import { wordOfField } from "./block-guide.ts";
import { kindOf } from "./block-kind.ts";
import type { BlockKind } from "../../../nc/blocks/names.ts";
import { editClosedText } from "./session.ts";

/** Writes a word of the block whose form was open, while another page is shown. */
export const writeIntoBlock = (line: number, kind: BlockKind, word: string, text: string): void =>
  editClosedText((program) => {
    const index = startLines(program).indexOf(line),
      s = program.blocks[index]?.statement;
    const field = s && kindOf(s) === kind ? fieldsOf(s).find((each) => wordOfField(each) === word) : undefined;
    const next = s && field?.write(s, text);
    return next ? withBlock(program, index, next) : program;
  });
