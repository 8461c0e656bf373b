import { parse } from "../parse.ts";
import { blockText } from "../print.ts";
import type { Statement } from "../statement.ts";
import type { Style } from "../style.ts";
import { isoSeverity, type IsoIssue, type IsoProblem } from "./issue.ts";
import { isoBlocks, type IsoBlock } from "./lines.ts";
import { FIRST_MODAL } from "./modal.ts";
import { ENGLISH_NAMES, type IsoNames } from "./names.ts";
import { UNREAD_MARK } from "./print-iso.ts";
import { readIsoBlock } from "./read-block.ts";

/** A program as Klartext, with the reader's issues. */
export interface KlartextOfIso {
  readonly text: string;
  readonly issues: readonly IsoIssue[];
}

/** A Klartext block before printing; `number`: that of the DIN/ISO block. */
interface KlartextBlock {
  readonly statement: Statement;
  readonly number: number | null;
  readonly skip: boolean;
  readonly comment: string | null;
}

const FRAME = /^%(.*)G[ \t]*7([01])$/i;
const LONGEST_FRAME = 500;
/** Number of the last block, regardless of those before it. */
const LAST_NUMBER = 99_999_999;
const isBlank = ({ statement: { kind } }: KlartextBlock) => kind === "empty" || kind === "comment";

function frameOf({ text, number }: IsoBlock, hasStarted: boolean): Statement | null {
  const m = text.length > LONGEST_FRAME ? null : FRAME.exec(text);
  return (
    m && {
      kind: hasStarted || number === LAST_NUMBER ? "end" : "begin",
      name: (m[1] ?? "").trim(),
      unit: m[2] === "0" ? "INCH" : "MM",
    }
  );
}

/**
 * A block that was not understood, as text that Klartext does not understand either: marked where it could be mistaken
 * for a block.
 */
function unread(block: IsoBlock): Statement {
  const text = [block, ...block.parameters].map((line) => line.text).join(" ");
  const isUnknown = parse(`0 ${text}`).blocks[0]?.statement.kind === "unknown";
  return { kind: "unknown", text: isUnknown ? text : `${UNREAD_MARK} ${text}` };
}

/**
 * The Klartext blocks of a DIN/ISO block. The first gets its number and comment; a comment without a place becomes a
 * block.
 */
function blocksOf(block: IsoBlock, statements: readonly Statement[]): KlartextBlock[] {
  const { number, skip, comment } = block;
  const isCycle = statements[0]?.kind === "cycle";
  // A purely modal block becomes no block; the head of a list takes no comment, its last parameter has a label.
  const standsAlone =
    comment !== null &&
    (statements.length === 0 || (isCycle && (block.parameters.length > 0 || !block.text.includes("="))));
  const separate: KlartextBlock[] = standsAlone
    ? [{ statement: { kind: "comment", text: comment }, number: isCycle ? null : number, skip, comment: null }]
    : [];
  return [
    ...separate,
    ...statements.map((statement, i) => ({
      statement,
      number: i === 0 ? number : null,
      skip,
      comment: i === 0 && !isCycle ? comment : null,
    })),
  ];
}

const commonDivisor = (a: number, b: number): number => (b === 0 ? a : commonDivisor(b, a % b));

/** The numbers of the file with room for inserted blocks; null where they do not ascend or leave no room. */
function numbersOfFile(output: readonly KlartextBlock[]): (number | null)[] | null {
  const given = output.flatMap(({ number }) => (number === null ? [] : [number]));
  if (given.length === 0) return null;
  const step = given.length > 1 ? Math.max(1, given.reduce(commonDivisor)) : 1;
  const numbers: (number | null)[] = [];
  let last = -1;
  for (const block of output) {
    if (block.number === null && isBlank(block)) {
      numbers.push(null);
      continue;
    }
    const number: number = block.statement.kind === "end" ? last + step : (block.number ?? last + 1);
    if (number <= last) return null;
    numbers.push(number);
    last = number;
  }
  return numbers;
}

function countedNumbers(output: readonly KlartextBlock[]): (number | null)[] {
  let next = 0;
  return output.map((block) => (block.number === null && isBlank(block) ? null : next++));
}

/**
 * Translates a DIN/ISO program into Klartext, block by block with its modal state. `names`: names and labels missing in
 * DIN/ISO. Text that is not understood is kept and reported; any text is read, and nothing throws.
 */
export function klartextOfIso(text: string, style: Style, names: IsoNames = ENGLISH_NAMES): KlartextOfIso {
  const output: KlartextBlock[] = [];
  const issues: IsoIssue[] = [];
  let modal = FIRST_MODAL;
  let hasStarted = false;
  for (const block of isoBlocks(text)) {
    const { number, skip, comment } = block;
    const report = (problems: readonly IsoProblem[]) => {
      for (const { at, ...problem } of problems)
        issues.push({
          ...problem,
          severity: isoSeverity(problem.code),
          number,
          line: block.line,
          column: block.column + at,
        } as IsoIssue);
    };
    if (block.text === "") {
      const statement: Statement = comment === null ? { kind: "empty" } : { kind: "comment", text: comment };
      output.push({ statement, number, skip, comment: null });
      continue;
    }
    const frame = frameOf(block, hasStarted);
    hasStarted = true;
    if (frame) {
      // The last block number consists of nines, more of them on newer controls.
      output.push({ statement: frame, number: frame.kind === "end" ? null : number, skip, comment });
      continue;
    }
    const read = readIsoBlock(block, { modal, names });
    modal = read.modal;
    report(read.problems);
    for (const m of blocksOf(block, read.statements ?? [unread(block)])) output.push(m);
  }
  const fileNumbers = numbersOfFile(output);
  if (!fileNumbers && output.some(({ number }) => number !== null))
    issues.push({
      code: "isoBlocksRecounted",
      severity: isoSeverity("isoBlocksRecounted"),
      number: null,
      line: 1,
      column: 1,
      data: {},
    });
  const numbers = fileNumbers ?? countedNumbers(output);
  const written = output.map(({ statement, skip, comment }, i) =>
    blockText(numbers[i] ?? null, statement, style, { skip, comment }),
  );
  return { text: written.join(""), issues };
}
