/** Line ends of a text, uniform or mixed. The editor works on lines; saving must restore the original bytes. */
export type LineEnds = "\n" | "\r\n" | "\r" | "mixed";

/** Line ends of a text; a text of one line counts as ending in \n. */
export function lineEndsOf(text: string): LineEnds {
  if (!text.includes("\r")) return "\n";
  const ends: LineEnds[] = [];
  if (text.includes("\r\n")) ends.push("\r\n");
  if (/\r(?!\n)/.test(text)) ends.push("\r");
  if (/(?:^|[^\r])\n/.test(text)) ends.push("\n");
  return ends.length === 1 ? (ends[0] ?? "\n") : "mixed";
}

/** The text as an editor holds it, lines ending in \n. Mixed ends stay as they are: their \r are characters. */
export const toEditor = (text: string, ends: LineEnds): string =>
  ends === "mixed" || ends === "\n" ? text : text.replaceAll(ends, "\n");

/** The text as it was read. */
export const fromEditor = (text: string, ends: LineEnds): string =>
  ends === "mixed" || ends === "\n" ? text : text.replaceAll("\n", ends);
