import { LONGEST_LINE } from "../longest-line.ts";
import { isoTokens } from "./tokens.ts";
import { FIRST_CYCLE } from "./words.ts";

/** One line of a DIN/ISO program, without ` *`. */
interface IsoLine {
  readonly number: number | null;
  readonly skip: boolean;
  /** The text after the number, without comment. */
  readonly text: string;
  /** The comment after `;`, null without one. */
  readonly comment: string | null;
  /** Line of the file from 1, and column of `text` from 1. */
  readonly line: number;
  readonly column: number;
  /** The line continues with `~`. */
  readonly open: boolean;
}

/** One block: a line, and for a cycle the lines of its parameters. */
export interface IsoBlock extends IsoLine {
  readonly parameters: readonly Pick<IsoLine, "text" | "comment">[];
}

const HEAD =
  /^[ \t\u00a0\ufeff]*(\/?)[ \t]*(?:(?:N[ \t]*|(?=\d+[ \t]+[A-Z%]))(\d{1,9})(?!\d)[ \t]*(\/?))?[ \t\u00a0]*/i;
const CYCLE = /^G[ \t]*[1-9]\d\d(?!\d)/i;

/** The text without a mark and the blanks around it at its end; null without the mark. */
function withoutEnding(text: string, mark: string): string | null {
  const trimmed = text.trimEnd();
  return trimmed.endsWith(mark) ? trimmed.slice(0, -mark.length).trimEnd() : null;
}
const withoutStar = (text: string) => withoutEnding(text, "*") ?? text.trimEnd();
/** The text of a line that continues (` ~`, ` ~ *` or ` * ~`), without the mark; null for any other line. */
function continued(text: string): string | null {
  const cut = withoutEnding(withoutStar(text), "~");
  return cut === null ? null : withoutStar(cut);
}
/** A star belongs to a comment unless a blank stands before it. */
const withoutCommentStar = (text: string) =>
  /(?:^|[ \t])\*$/.test(text.slice(-2)) ? withoutStar(text) : text.trimEnd();

/** Where the comment starts: the first `;` outside quotes, or -1. A quote that is never closed is no quote. */
function commentAt(text: string): number {
  const first = text.indexOf(";");
  let quoted = false;
  for (let i = 0; i < text.length; i += 1) {
    if (text[i] === '"') quoted = !quoted;
    else if (text[i] === ";" && !quoted) return i;
  }
  return quoted ? first : -1;
}

function lineOf(raw: string, line: number, inCycle: boolean): IsoLine {
  const head = HEAD.exec(raw);
  const column = (head?.[0].length ?? 0) + 1;
  const whole = raw.slice(column - 1).trimEnd();
  const number = head?.[2] === undefined ? null : Number(head[2]);
  const common = { number, skip: head?.[1] === "/" || head?.[3] === "/", line, column };
  if (raw.length > LONGEST_LINE) return { ...common, text: whole, comment: null, open: false };
  const cut = inCycle || CYCLE.test(whole) ? continued(whole) : null;
  const body = cut ?? whole;
  const at = commentAt(body);
  return at < 0
    ? { ...common, text: withoutStar(body), comment: null, open: cut !== null }
    : {
        ...common,
        text: body.slice(0, at).trimEnd(),
        comment: withoutCommentStar(body.slice(at + 1)),
        open: cut !== null,
      };
}

/** Whether a line contains parameters of the preceding cycle, not an assignment of its own. */
function belongs(next: IsoLine, head: IsoLine, open: boolean): boolean {
  if (next.number !== null || !/^Q[LR]?\d/i.test(next.text) || isoTokens(next.text).some((t) => t.letter !== "Q"))
    return false;
  const alone = head.number !== null && !/\bQ\d/i.test(head.text);
  return open || alone || next.comment !== null || Number(/\d+/.exec(next.text)?.[0]) >= FIRST_CYCLE;
}

/** The blocks of a DIN/ISO text. Lines of a cycle are joined, by `~` or as its parameters. */
export function isoBlocks(text: string): IsoBlock[] {
  const raws = text.split(/\r\n|\n|\r/);
  if (raws.at(-1) === "") raws.pop();
  const blocks: IsoBlock[] = [];
  for (let i = 0; i < raws.length;) {
    const head = lineOf(raws[i] ?? "", i + 1, false);
    i += 1;
    const parameters: IsoLine[] = [];
    if (CYCLE.test(head.text)) {
      for (let open = head.open; i < raws.length; i += 1) {
        const next = lineOf(raws[i] ?? "", i + 1, true);
        if (!belongs(next, head, open)) break;
        parameters.push(next);
        open = next.open;
      }
    }
    blocks.push({ ...head, parameters });
  }
  return blocks;
}

const FRAME = /^\s*%[^;]*G\s*7[01]\s*(?:\*\s*)?(?:;.*)?$/i;
const IN_ISO = /^\s*(?:\/\s*)?(?:(?:N\s*\d+\s*)?(?:\/\s*)?G\s*\d{1,3}(?!\d)|N\s*\d+\b.*\*\s*$)/i;
const IN_KLARTEXT = /^\s*(?:\/\s*)?(?:\d+\s*)?(?:BEGIN|END)[ \t]+PGM\b/i;
/** Lines, and characters of each, that decide the language of a program. */
const LOOKED_AT = 200;
const LOOKED_ALONG = 200;

/**
 * True for a text that is a DIN/ISO program: its first line is `%NAME G71`, or most of its lines are blocks with N or
 * G.
 */
export function isIsoText(text: string): boolean {
  const lines = text
    .slice(0, 100_000)
    .split(/\r\n|\n|\r/)
    .map((line) => line.slice(0, LOOKED_ALONG))
    .filter((line) => !/^\s*(?:;|$)/.test(line))
    .slice(0, LOOKED_AT);
  if (FRAME.test(lines[0] ?? "")) return true;
  if (lines.some((line) => IN_KLARTEXT.test(line))) return false;
  return lines.filter((line) => IN_ISO.test(line)).length * 2 > lines.length;
}
