import { readFileSync, writeFileSync } from "node:fs";

const PAGE = "docs/performance.md";

/** Replaces the lines between the marks of a name in a page: `<!-- name -->` and `<!-- /name -->`. */
export function writeIntoPage(name: string, lines: readonly string[], path = PAGE): void {
  const page = readFileSync(path, "utf8"),
    [begin, end] = [`<!-- ${name} -->`, `<!-- /${name} -->`];
  const [from, to] = [page.indexOf(begin), page.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`${path} has no place for ${name}`);
  writeFileSync(path, `${page.slice(0, from + begin.length)}\n${lines.join("\n").trim()}\n${page.slice(to)}`);
}

/** A Markdown table: the first columns contain words, the others numbers. */
export function markdownTable(words: number, head: readonly string[], rows: readonly (readonly string[])[]): string[] {
  const wide = head.map((name, i) => Math.max(3, name.length, ...rows.map((row) => row[i]?.length ?? 0)));
  const line = (cells: readonly string[]) =>
    `| ${cells.map((cell, i) => (i < words ? cell.padEnd(wide[i] ?? 0) : cell.padStart(wide[i] ?? 0))).join(" | ")} |`;
  const rule = `|${wide.map((width, i) => (i < words ? "-".repeat(width + 2) : `${"-".repeat(width + 1)}:`)).join("|")}|`;
  return [line(head), rule, ...rows.map(line)];
}
