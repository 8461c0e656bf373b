import type { Dialect } from "./dialect.ts";
import { FileCheck } from "./file-check.ts";
import { endOfWords, type FileLine, fileLine, isEmptyLine, isRemark, linesOf } from "./file-lines.ts";
import { type FrameName, takeFrame } from "./frame.ts";
import { LineCursor } from "./line-cursor.ts";
import { listStart, looksLikeList, takeParameters } from "./list.ts";
import { refuse, type FileRefusal, type LineRefusal } from "./refusal.ts";

/** Longest piece of a file that a refusal quotes. */
const QUOTED = 40;

/** The block that is open while its lines are read. */
interface OpenBlock {
  /** Words that opened a list; empty for any other block. */
  readonly list: string;
  readonly isNumbered: boolean;
  /** The whole block is a remark, in which a `~` may be part of the text. */
  readonly isText: boolean;
  /** The previous line, if it ended in `~`. */
  tilde: FileLine | null;
  /** Whether any line of the block ended in `~`. */
  hadTilde: boolean;
  /** The previous line, if it had neither `~` nor the `*` that ends a DIN/ISO block. */
  unended: FileLine | null;
  /** Index of the refusal for the list without `~`; -1 without one. */
  refusedAt: number;
  /** Something in the block was refused: the rest is not checked. */
  isRefused: boolean;
}

/** The refusals of a control for a file of one language, in line order. */
export function readFile(text: string, dialect: Dialect): readonly FileRefusal[] {
  const reader = new FileReader(dialect);
  linesOf(text).forEach((line, i) => reader.read(fileLine(line, i + 1, dialect.letter)));
  return reader.finish();
}

class FileReader {
  private readonly check = new FileCheck();
  private open: OpenBlock | null = null;
  private begin: FrameName | null = null;
  private hasBegin = false;
  private hasEnd = false;
  private hasOutside = false;
  private last = 1;

  constructor(private readonly dialect: Dialect) {}

  read(line: FileLine): void {
    this.last = line.line;
    if (isEmptyLine(line)) return;
    const { open } = this;
    if (open?.tilde) {
      if (this.continues(line)) return this.readContinuation(line, open);
    } else if (open?.list && looksLikeList(line, open.isNumbered, open.hadTilde)) return this.readStray(line, open);
    this.close();
    this.readBlock(line);
  }

  finish(): readonly FileRefusal[] {
    this.close();
    if (!this.hasBegin) this.check.add(this.last, refuse(0, "beginMissing", { text: "" }));
    if (!this.hasEnd) this.check.add(this.last, refuse(0, "endMissing", {}));
    return this.check.found.toSorted((a, b) => a.line - b.line || a.column - b.column);
  }

  private readBlock(line: FileLine): void {
    const { check, dialect } = this;
    check.begin(line);
    const isText = isRemark(line);
    const { to, hasStar } = endOfWords(line, dialect.star);
    const cursor = () => new LineCursor(line.text, line.from, to);
    const hasWords = !isText && line.from < to;
    const list = hasWords ? dialect.listOpener(cursor()) : "";
    const tilde = line.tilde >= 0 ? line : null;
    const open: OpenBlock = {
      list,
      isNumbered: line.number !== "",
      isText,
      tilde,
      hadTilde: tilde !== null,
      unended: hasWords && !tilde && !hasStar ? line : null,
      refusedAt: -1,
      isRefused: false,
    };
    this.open = open;
    if (line.wrongNumber !== "")
      return this.refuse(
        line,
        open,
        refuse(line.text.indexOf(line.wrongNumber), "blockNumber", { text: line.wrongNumber }),
      );
    if (!hasWords) return;
    if (this.readFrame(line, cursor())) return;
    if (list !== "") return this.readHead(line, cursor(), open);
    const refused = dialect.checkBlock(cursor());
    // A line that continues is checked in its first word only.
    const isWhole = !tilde || line.comment >= 0;
    if (isWhole || (refused?.code === "unknownWord" && refused.at === line.from)) this.refuse(line, open, refused);
    if (!refused) this.readLabel(line, cursor());
  }

  private readHead(line: FileLine, cursor: LineCursor, open: OpenBlock): void {
    const start = listStart(cursor);
    const refused = this.dialect.checkBlock(new LineCursor(line.text, line.from, start));
    this.refuse(line, open, refused ?? takeParameters(new LineCursor(line.text, start, cursor.end)));
  }

  private refuse(line: FileLine, open: OpenBlock, refused: LineRefusal | null): void {
    if (!refused || open.isRefused) return;
    open.isRefused = true;
    this.check.add(line.line, refused);
  }

  /** Reads the beginning and end of the program; true for such a line. Text outside both is refused once. */
  private readFrame(line: FileLine, cursor: LineCursor): boolean {
    const side = this.dialect.frame(cursor, this.hasBegin);
    const text = line.text.slice(line.from, Math.min(line.to, line.from + QUOTED));
    if (!this.hasBegin && side !== "begin") {
      this.hasBegin = true;
      this.check.add(line.line, refuse(line.from, "beginMissing", { text }));
    } else if (this.hasEnd || (this.hasBegin && side === "begin")) {
      if (!this.hasOutside) this.check.add(line.line, refuse(line.from, "outsideProgram", { text }));
      this.hasOutside = true;
      return true;
    }
    if (side === null) return false;
    const { name, refused } = takeFrame(cursor, this.dialect.units);
    if (refused) this.check.add(line.line, refused);
    if (side === "begin") {
      this.hasBegin = true;
      this.begin = name;
    } else {
      this.hasEnd = true;
      this.compareNames(line, name);
    }
    return true;
  }

  private compareNames(line: FileLine, end: FrameName | null): void {
    const { begin } = this;
    if (!begin || !end || begin.name.toUpperCase() === end.name.toUpperCase()) return;
    this.check.add(
      line.line,
      refuse(end.at, "nameDiffers", { begin: begin.name.slice(0, QUOTED), end: end.name.slice(0, QUOTED) }),
    );
  }

  /** Ends the open block and reports a missing continuation or end. */
  private close(): void {
    const { open } = this;
    if (!open) return;
    if (open.tilde && !open.isText) this.check.add(open.tilde.line, refuse(open.tilde.tilde, "tildeAtEnd", {}));
    if (open.unended && this.dialect.star && open.refusedAt < 0)
      this.refuse(open.unended, open, refuse(open.unended.to, "starMissing", {}));
  }

  /** Whether a line goes on with the block whose line before ended in `~`: it has no number and opens no block. */
  private continues(line: FileLine): boolean {
    if (line.number !== "") return false;
    if (line.from >= line.to) return line.comment >= 0;
    return line.text.charAt(line.from) !== "*" && !this.dialect.opensBlock(line);
  }

  private readContinuation(line: FileLine, open: OpenBlock): void {
    open.tilde = line.tilde >= 0 ? line : null;
    // A line without a parameter goes on with a long comment.
    if (open.list === "" || !isParameterLine(line)) return;
    const { to, hasStar } = endOfWords(line, this.dialect.star);
    if (!open.tilde && !hasStar) open.unended = line;
    this.refuse(line, open, takeParameters(new LineCursor(line.text, line.from, to)));
  }

  /** Reads a list line that the previous line did not announce with `~`. */
  private readStray(line: FileLine, open: OpenBlock): void {
    const { found } = this.check;
    const first = found[open.refusedAt];
    if (first?.code === "listWithoutTilde")
      found[open.refusedAt] = { ...first, data: { ...first.data, lines: first.data.lines + 1 } };
    else {
      open.refusedAt = found.length;
      this.check.add(line.line, refuse(line.from, "listWithoutTilde", { list: open.list, lines: 1 }));
    }
    open.tilde = line.tilde >= 0 ? line : null;
  }

  private readLabel(line: FileLine, cursor: LineCursor): void {
    const set = this.dialect.labelSet(cursor);
    if (!set) return;
    const name = set.label.startsWith('"') ? set.label : String(Number(set.label));
    if (name === "0") return;
    const first = this.check.label(name, line.line);
    if (first !== null)
      this.check.add(line.line, refuse(set.at, "labelTwice", { label: set.label.slice(0, QUOTED), line: first }));
  }
}

const isParameterLine = (line: FileLine) => line.from < line.to && line.text.charAt(line.from).toUpperCase() === "Q";
