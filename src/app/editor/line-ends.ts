/** How the lines of a text end: all alike, or mixed. An editor keeps lines; the bytes must come back as they were. */
export type LineEnds = "\n" | "\r\n" | "\r" | "mixed";

/** Line ends of a text; a text of one line counts as ending in \n. */
export function lineEndsOf(text: string): LineEnds {
  let found: LineEnds | null = null;
  for (const [end] of text.matchAll(/\r\n|\n|\r/g)) {
    if (found !== null && found !== end) return "mixed";
    found = end as LineEnds;
  }
  return found ?? "\n";
}

/** The text as an editor holds it, lines ending in \n. Mixed ends stay as they are: their \r are characters. */
export const toEditor = (text: string, ends: LineEnds): string => (ends === "mixed" || ends === "\n" ? text : text.replaceAll(ends, "\n"));

/** The text as it was read. */
export const fromEditor = (
  text: string,
  ends: LineEnds,
): string => (ends === "mixed" || ends === "\n" ? text : text.replaceAll("\n", ends));
