/** Longest piece of a line that a refusal quotes. */
const QUOTED = 40;

export const isBlank = (c: string) => c === " " || c === "\t" || c === "\u00a0";
export const isDigit = (c: string) => c >= "0" && c <= "9" && c.length === 1;
export const isLetter = (c: string) => (c >= "A" && c <= "Z") || (c >= "a" && c <= "z");

/** A reading position in one line, up to `end`. Each method moves forwards only. */
export class LineCursor {
  constructor(
    readonly text: string,
    public at: number,
    readonly end: number,
  ) {}

  /** The character here, or `ahead` characters further on; empty beyond the end. */
  char(ahead = 0): string {
    return this.at + ahead < this.end ? this.text.charAt(this.at + ahead) : "";
  }

  blanks(): void {
    while (this.at < this.end && isBlank(this.text.charAt(this.at))) this.at += 1;
  }

  /** True when nothing but blanks is left; they are skipped. */
  get done(): boolean {
    this.blanks();
    return this.at >= this.end;
  }

  /** The letters and underscores from here on, in capitals; the cursor stays. */
  letters(): string {
    let to = this.at;
    while (to < this.end && (isLetter(this.text.charAt(to)) || this.text.charAt(to) === "_")) to += 1;
    return this.text.slice(this.at, to).toUpperCase();
  }

  /** The digits from here on. */
  digits(): string {
    const from = this.at;
    while (isDigit(this.char())) this.at += 1;
    return this.text.slice(from, this.at);
  }

  /** Skips blanks and takes `word` when it stands there, in capitals or not. */
  take(word: string): boolean {
    this.blanks();
    const to = this.at + word.length;
    if (to > this.end || this.text.slice(this.at, to).toUpperCase() !== word) return false;
    this.at = to;
    return true;
  }

  /** Skips blanks and takes `word` when it stands there as a word of its own. */
  takeWord(word: string): boolean {
    this.blanks();
    if (this.letters() !== word) return false;
    this.at += word.length;
    return true;
  }

  /** The text from here to the next blank, shortened; the cursor stays. */
  piece(): string {
    let to = this.at;
    while (to < this.end && to - this.at < QUOTED && !isBlank(this.text.charAt(to))) to += 1;
    return this.text.slice(this.at, to);
  }

  /** Takes a quoted text with both quotes; null when its end is missing. */
  quoted(): string | null {
    const close = this.text.indexOf('"', this.at + 1);
    if (close < 0 || close >= this.end) return null;
    const inside = this.text.slice(this.at + 1, close);
    this.at = close + 1;
    return inside;
  }
}
