import type { BlockIssue } from "./issue.ts";
import { readValue } from "./value.ts";
import type { Value } from "./words.ts";

/** One statement being read: its text without comment and continuation mark, and where it starts in its block. */
export class Scan {
  at = 0;
  readonly issues: BlockIssue[] = [];

  constructor(
    readonly text: string,
    readonly offset: number,
  ) {}

  /** Takes the match of a sticky pattern here, after blanks. */
  take(pattern: RegExp): RegExpExecArray | null {
    this.blanks();
    pattern.lastIndex = this.at;
    const m = pattern.exec(this.text);
    if (m) this.at = pattern.lastIndex;
    return m;
  }

  blanks(): void {
    for (let c = this.text.charCodeAt(this.at); c === 32 || c === 9 || c === 0xa0; c = this.text.charCodeAt(this.at))
      this.at += 1;
  }

  get done(): boolean {
    this.blanks();
    return this.at >= this.text.length;
  }

  get rest(): string {
    return this.text.slice(this.at).trim();
  }

  /** Takes everything up to the next blank. */
  word(): string {
    this.blanks();
    const from = this.at;
    while (this.at < this.text.length && !/\s/.test(this.text.charAt(this.at))) this.at += 1;
    if (this.at === from) this.at += 1;
    return this.text.slice(from, this.at);
  }

  /** Reads a matched value; a number beyond the safe range becomes an issue. */
  value(text: string): Value | null {
    const value = readValue(text);
    if (value === null)
      this.issue({ code: "badNumber", severity: "error", data: { text: text.slice(0, 40) } }, text.length);
    return value;
  }

  /** Adds an issue over the `length` characters before the reading position. */
  issue(
    i: Pick<BlockIssue, "code" | "severity" | "data">,
    length = 0,
    fix?: { readonly from: number; readonly length: number; readonly text: string },
  ): void {
    const offset = this.offset + this.at - length;
    if (i.code === "wordNotUnderstood" && this.extended(offset + length)) return;
    const put = fix && { fix: { offset: this.offset + fix.from, length: fix.length, text: fix.text } };
    this.issues.push({ ...i, offset, length, ...put } as BlockIssue);
  }

  /** Extends the last issue to `end` where it ends just before: adjacent unknown words are one issue. */
  private extended(end: number): boolean {
    const last = this.issues.at(-1);
    if (last?.code !== "wordNotUnderstood") return false;
    const from = last.offset - this.offset;
    const between = this.text.slice(from + last.length, this.at);
    if (!/^[ \t\u00a0]*\S+$/.test(between)) return false;
    this.issues[this.issues.length - 1] = {
      ...last,
      length: end - last.offset,
      data: { text: this.text.slice(from, from + Math.min(end - last.offset, 40)) },
    };
    return true;
  }

  /** Returns to a position after a failed attempt, dropping the issues found since. */
  back(at: number): void {
    this.at = at;
    this.issues.length = 0;
  }

  /** Reports a taken word as not understood. */
  unread(word: string): void {
    this.issue({ code: "wordNotUnderstood", severity: "warning", data: { text: word.slice(0, 40) } }, word.length);
  }

  missing(word: string): void {
    this.issues.push({
      code: "wordMissing",
      severity: "error",
      offset: this.offset,
      length: this.text.length,
      data: { word },
    });
  }

  /** Takes all remaining words as not understood. */
  leftOver(): string[] {
    const extra: string[] = [];
    while (!this.done) {
      const word = this.word();
      extra.push(word);
      this.unread(word);
    }
    return extra;
  }
}
