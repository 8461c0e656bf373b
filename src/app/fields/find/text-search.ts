import { LONGEST_LINE } from "../../../nc/longest-line.ts";

/** A place where a searched text occurs. */
export interface Match {
  readonly from: number;
  readonly to: number;
}

const escaped = (text: string) => text.replace(/[\\^$.*+?()[\]{}|]/g, String.raw`\$&`);

/** Longest block number with its skip mark, characters. */
const LONGEST_NUMBER = 20;
const BLOCK_NUMBER = /^[^\S\r\n]*(?:\/[^\S\r\n]*)?N?\d+(?![\d.,])/i;

/**
 * Searches in upper and lower case alike. A blank finds any number of blanks, since `L  X+5` and `L X+5` are the same
 * block. Null for an empty search, and for one that no line has room for: a pattern has a longest length too.
 */
function patternOf(sought: string): RegExp | null {
  return sought.trim() === "" || sought.length > LONGEST_LINE
    ? null
    : new RegExp(
        sought
          .split(/\s+/)
          .map(escaped)
          // A run of blanks is tried from its beginning only.
          .join(String.raw`(?<![^\S\r\n])[^\S\r\n]+`),
        "gi",
      );
}

/** Block numbers alone are not searched: they belong to no block, and replacing must not change them. */
function isInNumber(text: string, { from, to }: Match): boolean {
  const near = Math.max(0, to - LONGEST_NUMBER - 1);
  const line = near + text.slice(near, from).lastIndexOf("\n") + 1;
  if (to - line > LONGEST_NUMBER) return false;
  return to - line <= (BLOCK_NUMBER.exec(text.slice(line, line + LONGEST_NUMBER))?.[0].length ?? 0);
}

/** Every occurrence in a text, or in a part of it that begins at the start of a line. */
export function matchesIn(text: string, sought: string): readonly Match[] {
  const pattern = patternOf(sought);
  if (!pattern) return [];
  const found: Match[] = [];
  for (let hit = pattern.exec(text); hit; hit = pattern.exec(text)) {
    const match = { from: hit.index, to: hit.index + hit[0].length };
    if (!isInNumber(text, match)) found.push(match);
  }
  return found;
}

/** Index of the first occurrence at or behind an offset, or before it if `back`; around the end. -1 without any. */
export function nextMatch(matches: readonly Match[], offset: number, back = false): number {
  if (matches.length === 0) return -1;
  const at = back
    ? matches.findLastIndex(({ from }) => from < offset)
    : matches.findIndex(({ from }) => from >= offset);
  return at >= 0 ? at : back ? matches.length - 1 : 0;
}
