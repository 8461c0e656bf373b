import { type FileLine, isEmptyLine, isRemark } from "./file-lines.ts";
import type { FileRefusal, LineRefusal } from "./refusal.ts";

/** Collects refusals with their places, and counts blocks as a control would print them. */
export class FileCheck {
  readonly found: FileRefusal[] = [];
  /** Number of the block that is read. */
  block: number | null = null;
  /** Labels that are set so far, each with its line. */
  private readonly labels = new Map<string, number>();
  private next = 0;

  /** A new block starts with this line. A comment without a number counts for none. */
  begin(line: FileLine): void {
    const isSilent = line.number === "" && (isEmptyLine(line) || isRemark(line) || line.from >= line.to);
    const number = line.number === "" || line.number.length > 9 ? null : Number(line.number);
    this.block = number ?? (isSilent ? Math.max(0, this.next - 1) : this.next);
    if (number !== null || !isSilent) this.next = this.block + 1;
  }

  add(line: number, refused: LineRefusal, block = this.block): void {
    this.found.push({ line, column: refused.at + 1, block, code: refused.code, data: refused.data } as FileRefusal);
  }

  /** Records a label; returns the line of an earlier equal label, or null. */
  label(name: string, line: number): number | null {
    const first = this.labels.get(name);
    if (first === undefined) this.labels.set(name, line);
    return first ?? null;
  }
}
