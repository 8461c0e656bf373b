import { parse } from "./parse.ts";
import { statementLines } from "./print.ts";
import { hasListWithoutTilde, type Block, type Program } from "./program.ts";
import { styleAt } from "./read-style.ts";

const LINE = /[^\r\n]*(?:\r\n|\n|\r|$)/g;
const VALUE_LINE = /^[ \t\u00a0]*Q[LR]?\d+[ \t]*(?:=|[+-])/i;
const HEAD = /^[ \t\u00a0\ufeff]*\/?[ \t]*(?:[Nn]?\d+(?![\d.,])[ \t\u00a0]*\/?)?[ \t\u00a0]*/;

/** A list with ` ~` at the end of each line but the last; a wrapped name or label is joined to one line. */
function withTildes(program: Program, index: number, block: Block): readonly Block[] {
  const lines = (block.raw.match(LINE) ?? []).filter((line) => line !== "");
  const written = lines.flatMap((line, i) => (line.trim() === "" ? [] : [i]));
  const isWrapped = written.slice(1).some((i) => !VALUE_LINE.test(lines[i] ?? ""));
  if (isWrapped && block.statement.kind === "cycle") {
    const style = styleAt(program, index);
    const end = /(?:\r\n|\n|\r)$/.exec(block.raw)?.[0] ?? "";
    return parse((HEAD.exec(block.raw)?.[0] ?? "") + statementLines(block.statement, style).join(style.newLine) + end)
      .blocks;
  }
  const last = written.at(-1) ?? 0;
  const made = lines.map((line, i) => {
    const bare = line.trimEnd();
    return i >= last || bare === "" || bare.endsWith("~")
      ? line
      : `${bare} ~${/(?:\r\n|\n|\r)$/.exec(line)?.[0] ?? ""}`;
  });
  return parse(made.join("")).blocks;
}

/** The program with ` ~` in every list that lacks it, so that a control loads it. All other text stays as it is. */
export const withListTildes = (program: Program): Program => ({
  blocks: program.blocks.flatMap((block, i) => (hasListWithoutTilde(block) ? withTildes(program, i, block) : [block])),
});
