import { statementLines } from "../print.ts";
import { blockNumbers, type Block, type Program } from "../program.ts";
import type { Statement, StatementOf } from "../statement.ts";
import { LAYOUTS } from "../style.ts";
import { isoOfOlderCycle } from "./older-cycles.ts";
import { isoStatement, parametersText } from "./print-statement.ts";
import { isoWordFor } from "./words.ts";

/** A block without a DIN/ISO word, written as Klartext. */
export interface KeptBlock {
  /** Index of the block in the program. */
  readonly index: number;
  /** Its number in the file. */
  readonly number: number;
}

/** A program in DIN/ISO. */
export interface IsoProgram {
  readonly text: string;
  readonly untranslated: readonly KeptBlock[];
}

/** Whether a block has no effect on a control. */
const isSilent = ({ kind }: Statement) => kind === "empty" || kind === "comment" || kind === "structure";
const isBlank = ({ kind }: Statement) => kind === "empty" || kind === "comment";
/** Whether a block is written alike in both languages: formulas and texts. */
const isShared = (s: Statement) => (s.kind === "assign" && s.fn === null) || s.kind === "assignText";

/** Marks an untranslated DIN/ISO block that could be mistaken for a Klartext block. */
export const UNREAD_MARK = "ISO";

/** The Klartext of a block on one line. */
function keptText(s: Statement): string {
  if (s.kind === "cycle") return `CYCL DEF ${s.cycle}${s.name === "" ? "" : ` ${s.name}`}${parametersText(s)}`;
  const text = statementLines(s, LAYOUTS.tnc7).join(" ");
  return s.kind === "unknown" && text.startsWith(`${UNREAD_MARK} `) ? text.slice(UNREAD_MARK.length + 1) : text;
}

const frameText = (s: StatementOf<"begin" | "end">) => `%${s.name} ${isoWordFor({ kind: "unit", unit: s.unit })}`;

/** The older cycle at `index`: its DIN/ISO block and its number of Klartext blocks; null without a DIN/ISO word. */
function olderCycleAt(
  blocks: readonly Block[],
  index: number,
): { readonly text: string; readonly count: number } | null {
  const head = blocks[index];
  if (head?.statement.kind !== "cycleLine" || head.statement.line !== 0) return null;
  const { cycle } = head.statement;
  const lines: StatementOf<"cycleLine">[] = [head.statement];
  for (let b = blocks[index + 1]; b?.statement.kind === "cycleLine"; b = blocks[index + lines.length]) {
    const s = b.statement;
    if (s.cycle !== cycle || s.line !== lines.length || b.skip !== head.skip || b.comment !== undefined) break;
    lines.push(s);
  }
  const text = isoOfOlderCycle(cycle, lines);
  return text === null ? null : { text, count: lines.length };
}

/**
 * Prints a program in DIN/ISO: one block per line, each complete, with `N` and its number in Klartext. Blocks without a
 * DIN/ISO word are written as Klartext and listed in `kept`. Names of cycles and labels of parameters are lost.
 */
export function isoProgramText(program: Program): IsoProgram {
  const { blocks } = program;
  const numbers = blockNumbers(program);
  const newLine = /\r\n|\n|\r/.exec(blocks[0]?.raw ?? "")?.[0] ?? "\n";
  const first = blocks.findIndex(({ statement }) => !isBlank(statement));
  const last = blocks.findLastIndex(({ statement, number }) => number !== null || !isBlank(statement));
  const lines: string[] = [];
  const untranslated: KeptBlock[] = [];
  for (let i = 0, count = 1; i < blocks.length; i += count) {
    const { statement: s, skip, comment, number } = blocks[i] as Block;
    const older = olderCycleAt(blocks, i);
    count = older?.count ?? 1;
    const begins = s.kind === "begin" && i === first;
    const ends = s.kind === "end" && i === last;
    const word = older?.text ?? (begins || ends ? frameText(s) : isoStatement(s));
    const at = numbers[i] ?? 0;
    if (word === null && !isSilent(s) && !isShared(s)) untranslated.push({ index: i, number: at });
    if (s.kind === "empty" && number === null) lines.push("");
    else {
      const silent = begins || (number === null && s.kind === "comment");
      const head = silent ? "" : ends ? `${isoWordFor({ kind: "block", block: "end" })} ` : `N${at} `;
      lines.push(
        `${skip ? "/" : ""}${head}${word ?? keptText(s)}${comment === undefined ? "" : ` ;${comment}`} *`.replace(
          /(?<! ) {2,}\*$/,
          " *",
        ),
      );
    }
  }
  return { text: lines.map((line) => line + newLine).join(""), untranslated };
}
