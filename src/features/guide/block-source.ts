import { withBlock } from "../../nc/edit.ts";
import { parse } from "../../nc/parse.ts";
import { print, startLines, type Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { kindOf } from "../../app/fields/blocks/block-kind.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { fieldsOf } from "../../app/fields/blocks/block-fields.ts";
import { wordOfField } from "../../app/fields/blocks/block-guide.ts";
import type { WordField } from "../../app/fields/blocks/field.ts";
import { shownFile } from "../../app/document/shown-file.ts";
import { useEditor } from "../../app/document/store.ts";
import { withText, type ProgramWork } from "../../app/document/work.ts";
import { blockSample } from "./block-samples.ts";
import { useGuidedBlock } from "../../app/place/open-call.ts";

/** A block for the pictures of the guide: of the open program, or of a sample. */
export interface BlockSource {
  readonly program: Program;
  readonly index: number;
  readonly statement: Statement;
  /** Its line in the open program, from 1; null for a sample. */
  readonly line: number | null;
  /** Simulates with another text of the file that contains the block. */
  readonly work: (text: string) => ProgramWork;
}

/** The field of a word in a block; undefined if it has none. */
export const fieldOfWord = (s: Statement, word: string): WordField | undefined =>
  fieldsOf(s).find((field) => wordOfField(field) === word);

/** The source with another text in a word; null if that is not readable. */
export function textWith({ program, index, statement }: BlockSource, field: WordField, text: string): string | null {
  const next = field.write(statement, text);
  return next && print(withBlock(program, index, next));
}

function sourceIn(
  text: string,
  line: number,
  kind: BlockKind,
): Pick<BlockSource, "program" | "index" | "statement"> | null {
  const program = parse(text),
    index = startLines(program).indexOf(line),
    statement = program.blocks[index]?.statement;
  return statement && kindOf(statement) === kind ? { program, index, statement } : null;
}

/** The open block of the open program, if it is of this kind and its run may be shown. */
function ownSource(kind: BlockKind): BlockSource | null {
  const { program, work } = useEditor.getState();
  const { block } = useGuidedBlock.getState();
  if (!program || program.task?.veiled || block?.work !== work) return null;
  const file = shownFile(program);
  const found = block ? sourceIn(file.text, block.line, kind) : null;
  return found && block
    ? { ...found, line: block.line, work: (text) => withText(program, fileKey(file.name), text) }
    : null;
}

/** The sample of a kind of block, or the sample of one of its words. */
function sampleSource(kind: BlockKind, word: string | null): BlockSource | null {
  const sample = blockSample(kind, word),
    found = sample && sourceIn(sample.text, sample.line, kind);
  const work = (text: string): ProgramWork => ({ name: "SAMPLE.H", text, encoding: "utf-8" });
  return found && { ...found, line: null, work };
}

/** The possible sources of a kind of block, or of one of its words, the best first. */
export const blockSources = (kind: BlockKind, word: string | null): readonly BlockSource[] =>
  [ownSource(kind), sampleSource(kind, word)].filter((source) => source !== null);
